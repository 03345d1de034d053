import type { Server } from 'node:http';
import type { Plugin } from 'vite';
import { defineConfig } from 'vitest/config';

/** `npm run dev` answers /live by the stand-in engine; the built page has no part of it. */
const standIn: Plugin = {
  name: 'stand-in-engine',
  apply: 'serve',
  async configureServer(server) {
    if (!server.httpServer) return;
    const { attach } = (await server.ssrLoadModule('/dev/engine.ts')) as typeof import('./dev/engine');
    attach(server.httpServer as Server);
  },
};

// The page is baked into the executable and served under `default-src 'self'`: nothing may be inlined as data: and no
// script may stand in the HTML, hence no module preload polyfill and assets as files.
export default defineConfig({
  base: './',
  plugins: [standIn],
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  build: {
    target: 'es2022',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    reportCompressedSize: true,
    chunkSizeWarningLimit: 900,
  },
  test: {
    include: ['tests/**/*.test.ts'],
    coverage: { provider: 'v8', include: ['src/core/**'] },
  },
});
