import { defineConfig } from 'vitest/config';

// Tests of the whole studio: the real tool, the real page, Chromium. One file at a time, because they measure times.
export default defineConfig({
  test: {
    include: ['*_test.ts', '*_bench.ts'],
    testTimeout: 120_000,
    hookTimeout: 60_000,
    fileParallelism: false,
    maxWorkers: 1,
  },
});
