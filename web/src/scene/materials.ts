import { Color, type Material as Drawn, MeshBasicMaterial, MeshStandardMaterial, type Texture } from 'three';
import { present } from '../basics/assert';
import type { Material } from '../link/protocol';
import type { Quality } from './drawn';
import { crumpleTexture, type Pattern, patternTexture } from './textures';

interface Look {
  readonly colour: string;
  readonly pattern: Pattern;
  readonly roughness: number;
  readonly metalness: number;
  /** Depth of crumpling; 0 is smooth. */
  readonly relief: number;
}

const look = (colour: string, roughness: number, metalness = 0, pattern: Pattern = 'plain', relief = 0) => {
  return { colour, pattern, roughness, metalness, relief };
};

const LOOKS: Record<Material, Look> = {
  blanket: look('#e2dfd7', 0.82, 0, 'quilt', 1.2),
  liner: look('#cdcac1', 0.9, 0, 'liner', 2),
  tiles: look('#26272a', 0.7, 0, 'tiles'),
  leading_edge: look('#6d6f72', 0.55),
  radiator: look('#d5dade', 0.28, 0.85, 'panel'),
  boom: look('#efede7', 0.72, 0, 'seams', 1.2),
  padding: look('#d8d6cf', 0.8, 0, 'plain', 0.9),
  housing: look('#2c2e31', 0.6, 0.25),
  bright: look('#8a8d90', 0.4, 0.75),
  dark: look('#101113', 0.35, 0.3),
  glass: look('#07090c', 0.12, 0.4),
  metal: look('#b9bcbf', 0.38, 0.85),
  foil: look('#c9973f', 0.3, 0.9, 'crinkle', 2.4),
  structure: look('#9a978e', 0.75, 0.2),
  silver: look('#c3c7cc', 0.35, 0.6, 'crinkle', 2.4),
  solar: look('#6d86c9', 0.25, 0.3, 'cells'),
  rail: look('#d6a52c', 0.5, 0.1),
  scuffed: look('#d9d5cb', 0.6, 0, 'scuffed', 0.4),
  glow: look('#fff4de', 1),
};

/** Share of its brightness that a metal loses in the low profile, which has no reflections. */
const DULL = 0.55;
/** Prefix of the batch names of glowing faces; the name of the switch follows. */
const GLOW = 'glow ';
/** End of the names of materials on which the hand's shadow falls. */
const SHADED = ' shaded';
/** Brightness of the face of a lamp that is off. */
const UNLIT = 0.08;

/** Makes the materials of the low profile. */
export interface Shading {
  material(pattern: Texture | null, shaded: boolean): Drawn;
}

/** Materials of one profile, each made at its first use. */
export class Materials {
  private readonly made = new Map<string, Drawn>();
  private readonly textures = new Map<string, Texture>();

  /** `light`: light of the low profile. */
  constructor(
    private readonly quality: Quality,
    private readonly light: Shading,
  ) {}

  /**
   * Return the colour of a substance and the name of its batch. In the full profile each substance has a batch; in the
   * low profile all substances with the same pattern share one. The lamp faces of each switch are a separate batch.
   */
  look(substance: Material, lamps = ''): { batch: string; colour: Color } {
    const { colour, pattern, metalness } = LOOKS[substance];
    const tint = new Color(colour);
    if (substance === 'glow') return { batch: GLOW + lamps, colour: tint };
    if (this.quality === 'full') return { batch: substance, colour: tint };
    const dull = pattern === 'crinkle' ? 0 : DULL * metalness * metalness; // creases have their own reflections
    return { batch: pattern, colour: tint.multiplyScalar(1 - dull) };
  }

  /** Return whether a batch casts and receives shadows. */
  solid(batch: string): boolean {
    return !batch.startsWith(GLOW);
  }

  /** Light the faces of the lamps whose switches are on, and darken the faces of the other lamps. */
  lightUp(on: ReadonlySet<string>): void {
    for (const [batch, material] of this.made) {
      if (material instanceof MeshBasicMaterial && batch.startsWith(GLOW))
        material.color.setScalar(batch === GLOW || on.has(batch.slice(GLOW.length)) ? 1 : UNLIT);
    }
  }

  /** Return the material of a batch. `shaded`: whether the shadow of the hand falls on it in the low profile. */
  material(batch: string, shaded = false): Drawn {
    const name = shaded ? `${batch}${SHADED}` : batch;
    const known = this.made.get(name);
    if (known) return known;
    const made = this.make(batch, shaded);
    this.made.set(name, made);
    return made;
  }

  dispose(): void {
    for (const material of this.made.values()) material.dispose();
    for (const texture of this.textures.values()) texture.dispose();
  }

  private make(batch: string, shaded: boolean): Drawn {
    if (batch.startsWith(GLOW)) return new MeshBasicMaterial({ vertexColors: true });
    if (this.quality === 'low') return this.light.material(this.pattern(batch as Pattern), shaded);
    const { pattern, roughness, metalness, relief } = present(LOOKS[batch as Material], `material ${batch}`);
    return new MeshStandardMaterial({
      vertexColors: true,
      roughness,
      metalness,
      map: this.pattern(pattern),
      bumpMap: relief > 0 ? this.texture('crumple', () => crumpleTexture(512)) : null,
      bumpScale: relief,
    });
  }

  private pattern(pattern: Pattern): Texture | null {
    if (pattern === 'plain') return null;
    return this.texture(pattern, () => patternTexture(pattern, this.quality));
  }

  private texture(name: string, make: () => Texture): Texture {
    const texture = this.textures.get(name) ?? make();
    this.textures.set(name, texture);
    return texture;
  }
}
