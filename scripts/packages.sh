# Installs the Debian packages that are missing. Sourced by ./run and ./test:
#   ensure_packages name…

build_packages=(
  g++ cmake ninja-build pkg-config ccache
  libeigen3-dev nlohmann-json3-dev libassimp-dev libosmesa6-dev libcli11-dev libpng-dev zlib1g-dev libjpeg62-turbo-dev libhpdf-dev libxxhash-dev libsqlite3-dev libsodium-dev libssl-dev libboost1.81-dev libboost-url1.81-dev libspdlog-dev
  libgtest-dev librapidcheck-dev libbenchmark-dev
)
run_packages=(ffmpeg)  # a program of its own, for movies; all else works without it
test_packages=(clang-format clang-tidy python3-yaml python3-jsonschema chromium curl jq)
fuzz_packages=(clang-14 libclang-rt-14-dev)  # for ./test --long alone

ensure_packages() {
  local missing=() package
  local installed
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' 2>/dev/null | sed -n 's/^installed //p')
  for package in "$@"; do
    grep -qxF -- "$package" <<<"$installed" || missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "== Installing packages: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
      echo "These packages are missing, and there is neither root nor sudo to install them: ${missing[*]}" >&2
      return 1
    }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}
