import { expect, test } from 'vitest';
import { isSoftware } from '../src/page/quality';

test.each([
  ['ANGLE (Mesa, llvmpipe (LLVM 15.0.6 256 bits), OpenGL 4.5)', true],
  ['ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)), SwiftShader driver)', true],
  ['ANGLE (NVIDIA, NVIDIA GeForce RTX 3060 Direct3D11)', false],
])('%s is software drawing: %s', (renderer, software) => {
  expect(isSoftware(renderer)).toBe(software);
});
