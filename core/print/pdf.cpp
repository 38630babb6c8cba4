#include <hpdf.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "core/print/pages.h"
#include "core/print/print.h"

namespace toile::print {
namespace {

constexpr double kPoint = 25.4 / 72;  // mm
constexpr std::size_t kMostPages = 2000;

/// Remembers the first fault; libharu does nothing more with a document that has one.
void remember(HPDF_STATUS error, HPDF_STATUS detail, void* to) {
  auto& fault = *static_cast<std::string*>(to);
  if (fault.empty()) fault = "fault " + std::to_string(error) + ", " + std::to_string(detail);
}

struct Free {
  void operator()(HPDF_Doc doc) const { HPDF_Free(doc); }
};
using Document = std::unique_ptr<std::remove_pointer_t<HPDF_Doc>, Free>;

float points(double mm) { return static_cast<float>(mm / kPoint); }
float number(double value) { return static_cast<float>(value); }

/// The letters that the standard fonts have (of Latin-1); others become "?".
std::string in_latin1(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c < 0x80) {
      out += c < ' ' ? ' ' : text[i];
    } else if ((c == 0xC2 || c == 0xC3) && i + 1 < text.size()) {
      out += static_cast<char>((c & 3) << 6 | (static_cast<unsigned char>(text[++i]) & 0x3F));
    } else if (c >= 0xC0) {  // one for the whole character
      out += '?';
    }
  }
  return out;
}

/// Draws on one page in millimetres of the sheet.
class PageDrawing {
 public:
  PageDrawing(HPDF_Doc doc, HPDF_Font font, const Paper& paper) : page_(HPDF_AddPage(doc)), font_(font) {
    HPDF_Page_SetWidth(page_, points(paper.size.x));
    HPDF_Page_SetHeight(page_, points(paper.size.y));
    HPDF_Page_Concat(page_, number(1 / kPoint), 0, 0, number(1 / kPoint), 0, 0);  // mm from here on
  }

  void save() { HPDF_Page_GSave(page_); }
  void restore() { HPDF_Page_GRestore(page_); }
  void move(Vec2 by) { HPDF_Page_Concat(page_, 1, 0, 0, 1, number(by.x), number(by.y)); }
  void scale(double by) { HPDF_Page_Concat(page_, number(by), 0, 0, number(by), 0, 0); }
  void clip(Vec2 low, Vec2 size) {
    HPDF_Page_Rectangle(page_, number(low.x), number(low.y), number(size.x), number(size.y));
    HPDF_Page_Clip(page_);
    HPDF_Page_EndPath(page_);
  }
  void width(double mm) { HPDF_Page_SetLineWidth(page_, number(mm)); }
  void rectangle(Vec2 low, Vec2 size) {
    HPDF_Page_Rectangle(page_, number(low.x), number(low.y), number(size.x), number(size.y));
    HPDF_Page_Stroke(page_);
  }

  void stroke(const Stroke& stroke) {
    if (stroke.curves.empty()) return;
    const HPDF_UINT16 dashes[] = {4, 2};
    HPDF_Page_SetDash(page_, dashes, stroke.pen == Pen::kInner ? 2 : 0, 0);
    width(stroke.pen == Pen::kOutline ? 0.4 : 0.25);
    const Vec2 start = stroke.curves.front().p0;
    HPDF_Page_MoveTo(page_, number(start.x), number(start.y));
    for (const pattern::CubicBezier& c : stroke.curves)
      HPDF_Page_CurveTo(page_, number(c.p1.x), number(c.p1.y), number(c.p2.x), number(c.p2.y), number(c.p3.x),
                        number(c.p3.y));
    if (stroke.closed) HPDF_Page_ClosePath(page_);
    HPDF_Page_Stroke(page_);
    HPDF_Page_SetDash(page_, nullptr, 0, 0);
  }

  void text(const Caption& caption) {
    HPDF_Page_BeginText(page_);
    HPDF_Page_SetFontAndSize(page_, font_, number(caption.height));
    HPDF_Page_TextOut(page_, number(caption.at.x), number(caption.at.y), in_latin1(caption.text).c_str());
    HPDF_Page_EndText(page_);
  }

 private:
  HPDF_Page page_;
  HPDF_Font font_;
};

/// Names of pieces are at least so high, mm.
void draw(PageDrawing& drawing, const Sheet& sheet, double least_name = 0) {
  for (const Stroke& stroke : sheet.strokes) drawing.stroke(stroke);
  for (Caption caption : sheet.captions) {
    if (caption.names_piece) caption.height = std::max(caption.height, least_name);
    drawing.text(caption);
  }
}

/// How the pages lie, small.
void draw_map(PageDrawing& drawing, const Sheet& sheet, const Pages& pages, const Paper& paper,
              const std::string& title) {
  const Vec2 window = window_of(paper);
  const Vec2 whole{pages.columns * window.x, pages.rows * window.y};
  constexpr double kHead = 20;  // mm
  const double scale = std::min({1.0, window.x / whole.x, (window.y - kHead) / whole.y});
  drawing.text({title, {kMargin, paper.size.y - kMargin - 8}, 8});
  drawing.text({std::to_string(pages.shown.size()) +
                    " pages. Print at 100 %, cut or fold along the frames, glue them as they lie here.",
                {kMargin, paper.size.y - kMargin - 15},
                4});
  drawing.save();
  drawing.move({kMargin, paper.size.y - kMargin - kHead - scale * whole.y});
  drawing.scale(scale);
  drawing.move({0, whole.y - sheet.size.y});
  draw(drawing, sheet, 3 / scale);
  drawing.width(0.2 / scale);
  for (const Page& page : pages.shown) {
    drawing.rectangle(page.corner, window);
    drawing.text({page.name, page.corner + Vec2{0.05 * window.x, 0.05 * window.y}, 0.15 * window.x});
  }
  drawing.restore();
}

const Page* page_at(const Pages& pages, int column, int row) {
  const auto found = std::find_if(pages.shown.begin(), pages.shown.end(),
                                  [&](const Page& page) { return page.column == column && page.row == row; });
  return found == pages.shown.end() ? nullptr : &*found;
}

void draw_page(PageDrawing& drawing, const Sheet& sheet, const Pages& pages, const Page& page,
               const Paper& paper) {
  const Vec2 window = window_of(paper);
  drawing.save();
  drawing.clip({kMargin, kMargin}, window);
  drawing.move(Vec2{kMargin, kMargin} - page.corner);
  draw(drawing, sheet);
  drawing.restore();
  drawing.width(0.15);
  drawing.rectangle({kMargin, kMargin}, window);
  drawing.text({page.name, {kMargin + 2, kMargin + 2}, 6});
  // The neighbours' names stand at the frame's middles.
  const Vec2 middle{paper.size.x / 2, paper.size.y / 2};
  const double far = kMargin + 2;
  const auto neighbour = [&](int across, int down, Vec2 at) {
    if (const Page* other = page_at(pages, page.column + across, page.row + down))
      drawing.text({other->name, at, 3});
  };
  neighbour(-1, 0, {far, middle.y});
  neighbour(1, 0, {paper.size.x - far - 5, middle.y});
  neighbour(0, -1, {middle.x, paper.size.y - far - 3});
  neighbour(0, 1, {middle.x, far});
}

}  // namespace

Result<std::string> pattern_pdf(const pattern::Pattern& pattern, const std::string& title,
                                const Paper& paper) {
  if (pattern.panels.empty()) return Error{"print.nothing", "the pattern has no piece to print", ""};
  const Sheet sheet = lay_out(pattern, title, square_width(pattern, window_of(paper)));
  const Vec2 window = window_of(paper);
  if (sheet.size.x * sheet.size.y > kMostPages * window.x * window.y)
    return Error{"print.too_large", "the pattern takes more than " + std::to_string(kMostPages) + " pages",
                 ""};
  const Pages pages = cut_up(sheet, paper);
  std::string fault;
  const Document doc(HPDF_New(remember, &fault));
  if (!doc) return Error{"print.pdf", "a PDF cannot be begun", "", ErrorKind::kInternal};
  const HPDF_Font font = HPDF_GetFont(doc.get(), "Helvetica", "WinAnsiEncoding");
  HPDF_SetInfoAttr(doc.get(), HPDF_INFO_TITLE, in_latin1(title).c_str());
  PageDrawing map(doc.get(), font, paper);
  draw_map(map, sheet, pages, paper, title);
  for (const Page& page : pages.shown) {
    PageDrawing drawing(doc.get(), font, paper);
    draw_page(drawing, sheet, pages, page, paper);
  }
  HPDF_SaveToStream(doc.get());
  std::string bytes(HPDF_GetStreamSize(doc.get()), '\0');
  HPDF_ResetStream(doc.get());
  auto size = static_cast<HPDF_UINT32>(bytes.size());
  if (size > 0) HPDF_ReadFromStream(doc.get(), reinterpret_cast<HPDF_BYTE*>(bytes.data()), &size);
  if (!fault.empty() || size != bytes.size())
    return Error{"print.pdf", "the PDF could not be made: " + fault, title, ErrorKind::kInternal};
  return bytes;
}

}  // namespace toile::print
