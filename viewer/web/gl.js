// The little of WebGL2 that both views share: programs, data textures, a target to draw into.
class GraphicsProblem extends Error {}

/// A canvas has one context; it may have been made before. With a depth of its own, pictures of its
/// size are drawn into it, without a copy.
const kContextOptions = {
  antialias: false, alpha: false, depth: true, stencil: false, powerPreference: 'high-performance',
};

class Graphics {
  constructor(canvas) {
    this.canvas = canvas;
    const gl = canvas.getContext('webgl2', kContextOptions);
    if (!gl) throw new GraphicsProblem('WebGL2 is missing in this browser, or switched off.');
    this.gl = gl;
    this.target = this.drawn = this.scratch = null;
    this.sum = null;
    // Sums of pictures need more than eight bits.
    this.canSum = gl.getExtension('EXT_color_buffer_float') !== null;
    this.nothing = gl.createVertexArray();  // all vertices are made in the shaders
  }

  /// A program of shader files by name; `shared`, files and lines that begin with #, are put before
  /// the fragment and vertex shaders, `more` before the fragment shader alone.
  program(vertex, fragment, shared = [], more = []) {
    const gl = this.gl;
    const program = gl.createProgram();
    const parts = [[gl.VERTEX_SHADER, vertex, []], [gl.FRAGMENT_SHADER, fragment, more]];
    for (const [kind, name, own] of parts) {
      const stage = `#define kVertex ${kind === gl.VERTEX_SHADER ? 1 : 0}`;
      const source =
          ['common.glsl', stage, ...shared, ...own, name].map(shaderSource).join('\n');
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost())
        throw new GraphicsProblem(`The shader ${name} does not compile: ` +
                                  gl.getShaderInfoLog(shader));
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new GraphicsProblem(`The shader ${fragment} does not link: ` +
                                gl.getProgramInfoLog(program));
    const locations = new Map();
    return {program, at: (name) => {
      if (!locations.has(name)) locations.set(name, gl.getUniformLocation(program, name));
      return locations.get(name);
    }};
  }

  /// Rows of `perRow` records of `texels` RGBA floats each.
  dataTexture(numbers, texels, perRow) {
    const gl = this.gl;
    const width = texels * perRow;
    const height = Math.max(1, Math.ceil(numbers.length / (4 * width)));
    if (Math.max(width, height) > gl.getParameter(gl.MAX_TEXTURE_SIZE))
      throw new GraphicsProblem('The manifold is too large for this graphics card.');
    const padded = new Float32Array(4 * width * height);
    padded.set(numbers);
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, padded);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
      gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    return texture;
  }

  /// A framebuffer of that size and format to draw into, in place of one.
  renewed(old, width, height, format) {
    const gl = this.gl;
    if (old && old.width === width && old.height === height) return old;
    this.release(old);
    const framebuffer = gl.createFramebuffer();
    const colour = gl.createRenderbuffer();
    const depth = gl.createRenderbuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.bindRenderbuffer(gl.RENDERBUFFER, colour);
    gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
    gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, width, height);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.RENDERBUFFER, colour);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
    return {framebuffer, colour, depth, width, height};
  }

  /// Starts a picture of that size; present() scales it to the canvas. One that is `shown` and has the
  /// size of the canvas is drawn into it at once.
  begin(width, height, shown = false) {
    if (shown && width === this.canvas.width && height === this.canvas.height)
      this.target = this.ownTarget(width, height);
    else
      this.target = this.scratch = this.renewed(this.scratch, width, height, this.gl.RGBA8);
    this.prepare(this.target);
  }

  ownTarget(width, height) { return {framebuffer: null, width, height}; }

  /// Starts the `count`-th picture of a mean, from 1 on; needs canSum.
  beginMean(width, height, count) {
    const gl = this.gl;
    this.sum = this.renewed(this.sum, width, height, gl.RGBA16F);
    this.prepare(this.sum);
    gl.enable(gl.BLEND);
    gl.blendColor(0, 0, 0, 1 / count);
    gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
  }

  prepare(target) {
    const gl = this.gl;
    this.drawn = target;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
    gl.viewport(0, 0, target.width, target.height);
    gl.bindVertexArray(this.nothing);
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
    gl.depthMask(true);
    gl.depthFunc(gl.LEQUAL);
    gl.clearDepth(1);
    gl.clear(gl.DEPTH_BUFFER_BIT);
  }

  release(target) {
    if (!target) return;
    this.gl.deleteFramebuffer(target.framebuffer);
    this.gl.deleteRenderbuffer(target.colour);
    this.gl.deleteRenderbuffer(target.depth);
  }

  present() {
    const {gl, canvas, drawn} = this;
    if (drawn.framebuffer === null) return;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, drawn.framebuffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, drawn.width, drawn.height, 0, 0, canvas.width, canvas.height,
                       gl.COLOR_BUFFER_BIT,
                       drawn.width === canvas.width ? gl.NEAREST : gl.LINEAR);
  }

  /// What the canvas shows after present(), bottom row first; before the browser takes it.
  readCanvas() {
    const {gl, canvas} = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const pixels = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  }

  /// The pixels of the picture, bottom row first, before the browser takes it; waits until it is drawn.
  read() {
    const {gl, target} = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
    const pixels = new Uint8Array(4 * target.width * target.height);
    gl.readPixels(0, 0, target.width, target.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
  }

  /// One pixel of it, counted from the lower left corner.
  readAt(x, y) {
    const {gl, target} = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
    const pixel = new Uint8Array(4);
    gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return pixel;
  }

  /// Waits until everything is drawn.
  finish() {
    const {gl, target} = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffer);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
}

const shaderSource = (name) => name.startsWith('#') ? name : document.getElementById(`shader-${name}`).textContent;
