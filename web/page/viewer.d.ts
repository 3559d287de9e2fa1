// The scripts of viewer/web, which the pages of `tripus view` have, too. web/build.mjs joins them.
declare module 'viewer' {
  /** The picture of a manifold and its controls, in the elements of stage.html and controls.html. */
  export class Page {
    /** `data`: of viewer/web/page_data.hpp; `fragment`: the view; `address`: what the key L makes of it. */
    constructor(data: unknown, fragment: string, address?: (view: string) => string);
    readonly state: {themeName: string};
    readonly canvas: HTMLCanvasElement;
    start(): void;
    stop(): void;
    act(name: string): void;
    /** The fragment of the address that shows this view. */
    fragment(): string;
  }
  export const kContextOptions: WebGLContextAttributes;
  /** A number for people: twelve digits where it has them. */
  export function shown(x: number): string;
  export function fold(folded: boolean): void;
}
