import { defineConfig } from 'vite';

// The page is baked into the executable and served under `default-src 'self'`: nothing may be inlined as data: and no
// script may stand in the HTML, hence no module preload polyfill and assets as files.
export default defineConfig({
  base: './',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    reportCompressedSize: true,
    chunkSizeWarningLimit: 900,
  },
});
