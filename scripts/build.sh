# Configures and builds one preset of CMakePresets.json. Sourced by ./run and ./test:
#   build_preset release toile      (without a target: everything)

# ccache may reuse objects made with precompiled headers: our sources use no __TIME__.
export CCACHE_SLOPPINESS=pch_defines,time_macros

configure_preset() {
  local folder="build/$1"
  mkdir -p build
  echo "== Configuring $folder"
  cmake --preset "$1" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >"$folder.log" 2>&1 || {
    cat "$folder.log" >&2
    return 1
  }
}

build_preset() {
  local preset=$1
  shift
  local folder="build/$preset"
  # Once it is configured ninja sees by itself when a CMake file changes.
  if [ ! -f "$folder/build.ninja" ]; then configure_preset "$preset"; fi
  echo "== Building $folder"
  ninja -C "$folder" -j "$(nproc)" --quiet "$@"
}
