import type { AtRule, Plugin } from 'postcss';
import { defineConfig } from 'vitest/config';
import { ROOM } from './src/page/room';

// `npm run dev` serves the page with hot reload beside `aftdeck fly --no-browser`, whose socket it passes on.
const station = 'ws://127.0.0.1:8340';

/** Replaces `(--NAME)` in a container query by the condition of that name. */
const room: Plugin = {
  postcssPlugin: 'room',
  AtRule: {
    container: (rule: AtRule) => {
      rule.params = rule.params.replace(/\(--(\w+)\)/g, (_, name: string) => {
        const condition: string | undefined = (ROOM as Record<string, string>)[name];
        if (condition === undefined) throw rule.error(`--${name} has no condition in src/page/room.ts`);
        return condition;
      });
    },
  },
};

export default defineConfig({
  base: './',
  css: { postcss: { plugins: [room] } },
  build: {
    outDir: '../src/aftdeck/station/static',
    emptyOutDir: true,
    license: { fileName: 'notices.txt' },
    chunkSizeWarningLimit: 1000,
  },
  server: {
    proxy: {
      '/ws': { target: station, ws: true, changeOrigin: true, rewriteWsOrigin: true },
      '/planes': { target: station, changeOrigin: true },
    },
  },
  test: {
    include: ['tests/**/*.test.ts'],
    // What hangs shall fail; a slow machine shall not [ms].
    testTimeout: 60_000,
    css: true,
    // One module graph for all files: to load it for each file takes five times as long as all tests.
    pool: 'threads',
    isolate: false,
    unstubGlobals: true,
  },
});
