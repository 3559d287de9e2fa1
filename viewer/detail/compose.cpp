#include "viewer/detail/compose.hpp"

#include <algorithm>
#include <string>

#include <Eigen/Core>

namespace tripus::viewer {
namespace {

constexpr std::string_view kVertexShader = R"(#version 120
void main() { gl_Position = gl_Vertex; }
)";

// In front of the fragment shaders stand the version and what is defined: kSamples, kStep: of how
// many samples, in each direction, one has its openness found; kModel, 0 upper half-space, 1 a
// ball; kNooks, whether nooks are darkened; kDark, whether the background is dark.
constexpr std::string_view kBoth = R"(
uniform sampler2D colours;
uniform sampler2D depths;
uniform vec2 size;             // of the textures, pixels
uniform vec4 lens;             // projection: its [0][0], [1][1], [2][0], [2][1]
uniform vec2 range;            // near, far

float distance_at(vec2 at) {
  float z = 2.0 * texture2D(depths, at).r - 1.0;
  return 2.0 * range.x * range.y / (range.y + range.x - z * (range.y - range.x));
}
vec2 picture_at(vec2 at) { return (2.0 * at - 1.0 + lens.zw) / lens.xy; }
)";

// Red, green and blue: the distance, alpha: how much of the sky above a point its surroundings
// leave open.
constexpr std::string_view kOpennessShader = R"(
uniform float reach;           // of the darkening, in the model's unit

// Of the middle of a pixel, where its depth is known: elsewhere even round surfaces had nooks.
vec3 place(vec2 at) {
  at = (floor(at * size) + 0.5) / size;
  return vec3(picture_at(at), -1.0) * distance_at(at);
}

void main() {
  vec2 pixel = float(kStep) * floor(gl_FragCoord.xy) + float(kStep / 2) + 0.5;
  vec2 at = pixel / size;
  float d = distance_at(at);
  vec3 p = vec3(picture_at(at), -1.0) * d;
  // The slope of the surface, from the nearer neighbours on each side.
  vec3 west = place(at - vec2(1.0, 0.0) / size), east = place(at + vec2(1.0, 0.0) / size);
  vec3 south = place(at - vec2(0.0, 1.0) / size), north = place(at + vec2(0.0, 1.0) / size);
  vec3 across = abs(west.z - p.z) < abs(east.z - p.z) ? p - west : east - p;
  vec3 along = abs(south.z - p.z) < abs(north.z - p.z) ? p - south : north - p;
  vec3 normal = normalize(cross(across, along));
  float closed = 0.0;
  // Each looks elsewhere, or there were bands.
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715))));
  vec2 way_on = vec2(cos(turn), sin(turn)), ray = 0.5 * lens.xy * reach / d;
  for (int i = 0; i < kPlaces; ++i) {
    float share = (float(i) + 0.5) / float(kPlaces);
    vec3 way = place(at + ray * share * way_on) - p;
    float length2 = dot(way, way);
    float fade = max(1.0 - length2 / (reach * reach), 0.0);
    closed += fade * max(dot(normal, way) * inversesqrt(length2 + 1e-12) - 0.08, 0.0);
    // By the golden angle.
    way_on = vec2(-0.7373689 * way_on.x - 0.6754903 * way_on.y,
                  0.6754903 * way_on.x - 0.7373689 * way_on.y);
  }
  float open = 1.0 / (1.0 + 4.8 * closed / float(kPlaces));
  float whole = floor(16777215.0 * clamp((d - range.x) / (range.y - range.x), 0.0, 1.0));
  vec2 upper = floor(whole / vec2(65536.0, 256.0));
  gl_FragColor = vec4(vec3(upper, whole) - 256.0 * vec3(0.0, upper), 255.0 * open) / 255.0;
}
)";

constexpr std::string_view kComposeShader = R"(
uniform sampler2D openness;
uniform vec2 openness_size;
uniform float softness;        // 1 / distance at which surfaces are no longer one
uniform mat3 to_model;         // directions from eye space
uniform vec3 eye;              // in the model
uniform vec3 middle;           // of the scene, and its radius
uniform float extent;
const float dark = float(kDark);

vec3 background(vec2 at) {
  vec3 direction = to_model * normalize(vec3(picture_at(at), -1.0));
  vec3 high = mix(vec3(0.93, 0.945, 0.96), vec3(0.04, 0.065, 0.125), dark);
  vec3 low = mix(vec3(0.985, 0.985, 0.98), vec3(0.12, 0.17, 0.24), dark);
  vec3 sky = mix(high, low, smoothstep(0.0, 1.0, 1.0 - at.y));
#if kModel == 0
  // The plane at infinity, z = 0, fading out around the scene.
  float t = -eye.z / direction.z;
  vec2 ground = eye.xy + t * direction.xy - middle.xy;
  float fade = exp(-dot(ground, ground) / (3.2 * extent * extent));
  if (eye.z * direction.z < 0.0) sky = mix(sky, mix(vec3(0.80, 0.83, 0.86), vec3(0.19, 0.24, 0.31), dark), 0.75 * fade);
#else
  // The ball: a faint glass sphere.
  float b = dot(eye, direction);
  float gap = dot(eye, eye) - b * b, gap2 = gap * gap;
  vec3 glass = mix(vec3(0.74, 0.79, 0.85), vec3(0.45, 0.57, 0.70), dark);
  if (gap < 1.0 && b < 0.0) sky = mix(sky, glass, (1.0 - 0.6 * dark) * (0.18 + 0.42 * gap2 * gap2 * gap2));
#endif
  return sky;
}

// Of the four places around a sample where it is known, those on its surface.
float openness_at(vec2 pixel, float d) {
  vec2 place = (pixel - float(kStep / 2) - 0.5) / float(kStep);
  vec2 low = floor(place), part = place - low;
  vec2 sum = vec2(0.0);
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      vec4 there = texture2D(openness, (low + vec2(float(i), float(j)) + 0.5) / openness_size);
      float far = range.x + (range.y - range.x) *
          dot(there.rgb, vec3(65536.0, 256.0, 1.0) * (255.0 / 16777215.0));
      float weight = (i == 1 ? part.x : 1.0 - part.x) * (j == 1 ? part.y : 1.0 - part.y) + 1e-3;
      weight *= max(1.0 - softness * abs(far - d), 1e-4);
      sum += weight * vec2(there.a, 1.0);
    }
  }
  return sum.x / sum.y;
}

void main() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < kSamples; ++i) {
    for (int j = 0; j < kSamples; ++j) {
      vec2 pixel = float(kSamples) * floor(gl_FragCoord.xy) + vec2(float(i), float(j)) + 0.5;
      vec2 at = pixel / size;
      vec4 drawn = texture2D(colours, at);
      vec3 shown = drawn.rgb;
#if kNooks
      shown *= mix(vec3(0.05, 0.07, 0.12), vec3(1.0), openness_at(pixel, distance_at(at)));
#endif
      // Colours are weighed by their alpha already.
      sum += drawn.a == 1.0 ? shown : shown + (1.0 - drawn.a) * background(at);
    }
  }
  gl_FragColor = vec4(sum / float(kSamples * kSamples), 1.0);
}
)";

/// One triangle over the whole picture.
void draw_all() {
  glBegin(GL_TRIANGLES);
  glVertex2f(-1, -1);
  glVertex2f(3, -1);
  glVertex2f(-1, 3);
  glEnd();
}

/// Openness changes slowly: it is found for one sample of so many in each direction.
int step_of(int samples) { return std::max(2, samples); }

GLfloat number(double x) { return static_cast<GLfloat>(x); }

/// What both programs read.
void set_textures(const Uniform& uniform, const RenderTarget& target, const View& view) {
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, target.depth.name());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, target.colour.name());
  glUniform1i(uniform.at("colours"), 0);
  glUniform1i(uniform.at("depths"), 1);
  glUniform2f(uniform.at("size"), number(target.width), number(target.height));
  const Eigen::Matrix4d& p = view.projection;
  glUniform4f(uniform.at("lens"), number(p(0, 0)), number(p(1, 1)), number(p(0, 2)),
              number(p(1, 2)));
  glUniform2f(uniform.at("range"), number(view.near), number(view.far));
}

}  // namespace

void require_no_error() {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR)
    throw NoOpenGl("OpenGL reports the error " + std::to_string(error) +
                   " while drawing; try a smaller --size or fewer --cells");
}

void Composer::begin(const Frame& frame) {
  const int width = frame.width * frame.samples, height = frame.height * frame.samples;
  glGetIntegerv(GL_FRAMEBUFFER_BINDING, &picture_);
  if (target_.width != width || target_.height != height)
    target_ = make_render_target(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, target_.framebuffer.name());
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_DITHER);
  glClearColor(0, 0, 0, 0);
  glClearDepth(1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  glEnable(GL_DEPTH_TEST);
}

void Composer::make_programs(int samples, const PictureOptions& options) {
  const bool nooks = options.occlusion;
  const std::array<int, 4> wanted{samples, nooks ? 1 : 0,
                                  options.model == Model::kUpperHalfSpace ? 0 : 1,
                                  options.dark ? 1 : 0};
  if (wanted == made_) return;
  // More places where there is time for more samples.
  const std::string defined = "#version 120\n#define kSamples " + std::to_string(samples) +
                              "\n#define kStep " + std::to_string(step_of(samples)) +
                              "\n#define kNooks " + std::to_string(wanted[1]) +
                              "\n#define kModel " + std::to_string(wanted[2]) + "\n#define kDark " +
                              std::to_string(wanted[3]) + "\n#define kPlaces " +
                              (samples == 1 ? "10" : "24") + "\n" + std::string(kBoth);
  program_ = make_program(kVertexShader, defined + std::string(kComposeShader));
  if (nooks)
    openness_program_ = make_program(kVertexShader, defined + std::string(kOpennessShader));
  made_ = wanted;
}

void Composer::find_openness(double reach, const View& view, int samples) {
  const int step = step_of(samples);
  const int width = (target_.width + step - 1) / step, height = (target_.height + step - 1) / step;
  if (openness_.width != width || openness_.height != height)
    openness_ = make_render_target(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, openness_.framebuffer.name());
  glViewport(0, 0, width, height);
  const Uniform uniform{openness_program_.name()};
  glUseProgram(uniform.program);
  set_textures(uniform, target_, view);
  glUniform1f(uniform.at("reach"), number(reach));
  draw_all();
}

void Composer::finish(const PictureOptions& options, const Frame& frame, const View& view,
                      const Ball& scene) {
  glDisable(GL_DEPTH_TEST);
  const double reach = 0.22 * scene.radius;
  if (!frame.identities) make_programs(frame.samples, options);
  if (options.occlusion && !frame.identities) find_openness(reach, view, frame.samples);
  glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(picture_));
  glViewport(0, 0, frame.width, frame.height);
  if (frame.identities) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.framebuffer.name());
    glBlitFramebuffer(0, 0, target_.width, target_.height, 0, 0, frame.width, frame.height,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(picture_));
    return;
  }
  const Uniform uniform{program_.name()};
  glUseProgram(uniform.program);
  set_textures(uniform, target_, view);
  glActiveTexture(GL_TEXTURE2);
  glBindTexture(GL_TEXTURE_2D, openness_.colour.name());
  glActiveTexture(GL_TEXTURE0);
  glUniform1i(uniform.at("openness"), 2);
  glUniform2f(uniform.at("openness_size"), number(openness_.width), number(openness_.height));
  glUniform1f(uniform.at("softness"), number(4 / reach));
  const Eigen::Matrix3f to_model = view.model_view.topLeftCorner<3, 3>().transpose().cast<float>();
  glUniformMatrix3fv(uniform.at("to_model"), 1, GL_FALSE, to_model.data());
  const Eigen::Vector3f eye = view.eye.cast<float>(), middle = scene.centre.cast<float>();
  glUniform3fv(uniform.at("eye"), 1, eye.data());
  glUniform3fv(uniform.at("middle"), 1, middle.data());
  glUniform1f(uniform.at("extent"), number(scene.radius));
  draw_all();
  glUseProgram(0);
}

}  // namespace tripus::viewer
