# Builds and tests the page (web/). Sourced by ./run and ./test, after packages.sh:
#   build_web      web/dist, when a source is newer than it
#   test_web       the unit tests of the page and of the stream's codec
#   test_page_long whole ways in it, from a dropped DXF to a model and a movie, after test_page
#   test_page      the page in Debian's Chromium over the built server; wants package chromium

# Node as the machine has it; Debian's when there is none.
ensure_node() {
  command -v node >/dev/null && command -v npm >/dev/null && return 0
  ensure_packages nodejs npm
}

# Installs what package-lock.json names, when it has changed since.
install_web_packages() {
  ensure_node
  local installed=web/node_modules/.package-lock.json
  [ -f "$installed" ] && [ ! web/package-lock.json -nt "$installed" ] && return 0
  echo "== Installing the page's packages"
  (cd web && npm ci --no-audit --no-fund --loglevel=error)
  touch "$installed"
}

web_is_built() {
  local sources=(web/src web/public web/index.html web/package-lock.json web/tsconfig.json web/vite.config.ts proto/ts samples
    server/render/glsl/seams.glsl)
  [ -f web/dist/index.html ] && [ -z "$(find "${sources[@]}" -newer web/dist/index.html -print -quit)" ]
}

build_web() {
  web_is_built && return 0
  install_web_packages
  echo "== Building the page"
  (cd web && npm run --silent build -- --logLevel warn)
}

test_web() {
  install_web_packages
  echo "== Testing the page's parts"
  (cd web && npm run --silent check && npm run --silent test)
}

test_page() {
  build_web
  install_web_packages
  echo "== Testing the page in a browser (screenshots: out/e2e)"
  (cd web && npm run --silent e2e)
}

# From a dropped DXF to a model and a movie, of samples and of patterns from outside, through the page.
test_page_long() {
  echo "== Going whole ways in a browser"
  (cd web && npm run --silent e2e:long)
}
