#include "server/render/gl/context.h"

#include <GL/osmesa.h>

#include <array>
#include <string>

#ifdef __SANITIZE_ADDRESS__
// Mesa forgets about 150 bytes for every context; leaks of our own are still reported.
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa"; }
#endif
#ifdef __SANITIZE_THREAD__
// Mesa's own threads synchronise in ways that ThreadSanitizer cannot see in a library that it has not
// instrumented.
extern "C" const char* __tsan_default_suppressions() { return "called_from_lib:libOSMesa"; }
#endif

namespace toile::render {
namespace {

Error no_context(const std::string& why) {
  return {"render.no_context", why + "; stills need Mesa's off-screen library (libOSMesa) with OpenGL 3.3",
          "", ErrorKind::kInternal};
}

/// Mesa draws on the processor, without a display or a graphics card.
class OsMesaContext : public GlContext {
 public:
  ~OsMesaContext() override {
    if (context_ == nullptr) return;
    if (OSMesaGetCurrentContext() == context_) OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    OSMesaDestroyContext(context_);
  }

  Status open() {
    const int wanted[] = {OSMESA_FORMAT,
                          OSMESA_RGBA,
                          OSMESA_PROFILE,
                          OSMESA_CORE_PROFILE,
                          OSMESA_CONTEXT_MAJOR_VERSION,
                          3,
                          OSMESA_CONTEXT_MINOR_VERSION,
                          3,
                          0};
    context_ = OSMesaCreateContextAttribs(wanted, nullptr);
    if (context_ == nullptr) return no_context("no OpenGL context could be made");
    TRY(make_current());
    return load_functions();
  }

  Status make_current() override {
    if (OSMesaMakeCurrent(context_, surface_.data(), GL_UNSIGNED_BYTE, kSide, kSide) == GL_TRUE) return {};
    return no_context("the OpenGL context cannot be used on this thread");
  }

 private:
  Status load_functions() {
    const char* missing = nullptr;
#define TOILE_GL_LOAD(type, member)                                        \
  gl_.member = reinterpret_cast<type>(OSMesaGetProcAddress("gl" #member)); \
  if (gl_.member == nullptr) missing = "gl" #member;
    TOILE_GL_FUNCTIONS(TOILE_GL_LOAD)
#undef TOILE_GL_LOAD
    if (missing != nullptr) return no_context(std::string("OpenGL has no ") + missing);
    return {};
  }

  static constexpr int kSide = 4;  // the surface that OSMesa insists on; nothing is drawn there
  std::array<unsigned char, kSide * kSide * 4> surface_{};
  OSMesaContext context_ = nullptr;
};

}  // namespace

Result<std::unique_ptr<GlContext>> GlContext::create() {
  auto context = std::make_unique<OsMesaContext>();
  TRY(context->open());
  return std::unique_ptr<GlContext>(std::move(context));
}

}  // namespace toile::render
