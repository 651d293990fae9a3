import { defineConfig } from 'vitest/config';

// `npm run dev` serves the page with hot reload beside `aftdeck fly --no-browser`, whose socket it passes on.
const station = 'ws://127.0.0.1:8340';

export default defineConfig({
  base: './',
  build: {
    outDir: '../src/aftdeck/station/static',
    emptyOutDir: true,
    chunkSizeWarningLimit: 1000,
  },
  server: { proxy: { '/ws': { target: station, ws: true, changeOrigin: true, rewriteWsOrigin: true } } },
  // What hangs shall fail; a slow machine shall not [ms].
  test: { include: ['tests/**/*.test.ts'], testTimeout: 60_000 },
});
