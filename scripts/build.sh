# Configures and builds one preset of CMakePresets.json. Sourced by ./run and ./test:
#   build_preset release toile      (without a target: everything)

# ccache may reuse objects made with precompiled headers: our sources use no __TIME__.
export CCACHE_SLOPPINESS=pch_defines,time_macros

build_preset() {
  local preset=$1
  shift
  local folder="build/$preset"
  mkdir -p build
  if [ ! -f "$folder/build.ninja" ]; then  # from then on ninja sees by itself when a CMake file changes
    echo "== Configuring $folder"
    cmake --preset "$preset" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >"$folder.log" 2>&1 || {
      cat "$folder.log" >&2
      return 1
    }
  fi
  echo "== Building $folder"
  ninja -C "$folder" -j "$(nproc)" --quiet "$@"
}
