import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

const root = fileURLToPath(new URL('..', import.meta.url));
// Where `npm run dev` and `npm run preview` find the service.
const service = process.env.TOILE_SERVER ?? 'http://127.0.0.1:8460';

export default defineConfig({
  base: './',
  esbuild: { jsx: 'automatic', jsxImportSource: 'preact' },
  build: {
    target: 'es2022',
    // A sample's files are fetched, which a page from elsewhere than its own address must not do.
    assetsInlineLimit: (file) => (file.includes('/samples/') ? false : undefined),
    // three.js is one file of its own, fetched beside the page and not before it.
    chunkSizeWarningLimit: 900,
    rollupOptions: { output: { manualChunks: { three: ['three'] } } },
  },
  worker: { format: 'es' },
  server: {
    fs: { allow: [root] },
    proxy: { '/api': { target: service, ws: true } },
  },
  // The codec's tests lie outside of this folder, and so outside of where packages are looked for.
  resolve: { alias: { vitest: fileURLToPath(new URL('node_modules/vitest/dist/index.js', import.meta.url)) } },
  test: {
    root,
    include: ['web/test/**/*.test.{ts,tsx}', 'proto/ts/**/*.test.ts'],
    environment: 'node',
    css: true,
    globals: false,
    // Only so that what never ends does: nothing here is measured against the clock.
    testTimeout: 300_000,
    hookTimeout: 300_000,
  },
});
