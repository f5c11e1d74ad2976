// SPDX-License-Identifier: Apache-2.0
#include "sim/render/lit_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace horopter::sim {
namespace {

/// Light i's share of a vertex' colour, added to `target`.
std::string LightVertex(int i, const LightKind& light, bool shiny, const std::string& target) {
  std::string text = fmt::format("  {{\n    vec4 at = gl_LightSource[{}].position;\n", i);
  if (light.directional) {
    text += "    vec3 l = normalize(at.xyz);\n    float strength = 1.0;\n";
  } else {
    text += fmt::format(
        "    vec3 way = at.xyz - eye;\n"
        "    float d = length(way);\n"
        "    vec3 l = way / d;\n"
        "    float strength = 1.0 / (gl_LightSource[{0}].constantAttenuation +\n"
        "        d * (gl_LightSource[{0}].linearAttenuation +\n"
        "             d * gl_LightSource[{0}].quadraticAttenuation));\n"
        "    if (gl_LightSource[{0}].spotCutoff <= 90.0) {{\n"
        "      float along = dot(-l, normalize(gl_LightSource[{0}].spotDirection));\n"
        "      strength *= along < gl_LightSource[{0}].spotCosCutoff\n"
        "          ? 0.0 : pow(along, gl_LightSource[{0}].spotExponent);\n"
        "    }}\n",
        i);
  }
  text += fmt::format(
      "    float facing = dot(n, l);\n"
      "    vec3 c = gl_Color.rgb * (gl_LightSource[{0}].ambient.rgb +\n"
      "                             max(facing, 0.0) * gl_LightSource[{0}].diffuse.rgb);\n",
      i);
  if (shiny) {
    text += fmt::format(
        "    float mirrored = max(dot(n, normalize(l - normalize(eye))), 0.0);\n"
        "    if (facing > 0.0)\n"
        "      c += pow(mirrored, material.z) * material.y * gl_LightSource[{}].specular.rgb;\n",
        i);
  }
  return text + fmt::format("    {} += strength * c;\n  }}\n", target);
}

std::string ImageCoordinates(ImageKind kind) {
  switch (kind) {
    case ImageKind::kNone:
      return "";
    case ImageKind::kFlat:
      return "  image_at = gl_MultiTexCoord0.xyz;\n";
    case ImageKind::kFlatGenerated:
      return "  image_at = vec3(gl_Vertex.xy * image_scale.xy - 0.5, 0.0);\n";
    case ImageKind::kCube:
      return "  image_at = gl_Vertex.xyz * image_scale;\n";
  }
  return "";
}

std::string Varyings(const LitProgramKind& kind, int shadows) {
  std::string text = "varying vec3 base;\n";
  if (kind.image != ImageKind::kNone) text += "varying vec3 image_at;\n";
  for (int k = 0; k < shadows; ++k) {
    text += fmt::format("varying vec3 lit{0};\nvarying vec4 map_at{0};\n", k);
  }
  return text;
}

/// textureLod and textureSize came with GLSL 1.30.
std::string Version(const LitProgramKind& kind) {
  return kind.own_levels ? "#version 130\n" : "#version 120\n";
}

std::string VertexShader(const LitProgramKind& kind, int shadows) {
  std::string text = Version(kind) + "uniform vec3 material;\nuniform vec3 image_scale;\n";
  for (int k = 0; k < shadows; ++k) text += fmt::format("uniform mat4 map_from_eye{};\n", k);
  text += Varyings(kind, shadows);
  text +=
      "void main() {\n"
      "  gl_Position = ftransform();\n"
      "  vec4 eye4 = gl_ModelViewMatrix * gl_Vertex;\n"
      "  vec3 eye = eye4.xyz;\n"
      "  vec3 n = normalize(gl_NormalMatrix * gl_Normal);\n"
      "  vec3 sum = gl_Color.rgb * (material.x + gl_LightModel.ambient.rgb);\n";
  text += ImageCoordinates(kind.image);
  for (std::size_t i = 0; i < kind.lights.size(); ++i) {
    if (kind.lights[i].shadow) continue;
    text += LightVertex(static_cast<int>(i), kind.lights[i], kind.shiny, "sum");
  }
  text += "  base = clamp(sum, 0.0, 1.0);\n";
  int k = 0;
  for (std::size_t i = 0; i < kind.lights.size(); ++i) {
    if (!kind.lights[i].shadow) continue;
    text += "  sum = gl_Color.rgb * gl_LightModel.ambient.rgb;\n";
    text += LightVertex(static_cast<int>(i), kind.lights[i], kind.shiny, "sum");
    text +=
        fmt::format("  lit{0} = clamp(sum, 0.0, 1.0);\n  map_at{0} = map_from_eye{0} * eye4;\n", k);
    ++k;
  }
  return text + "}\n";
}

/// The level of the mipmap for the image's coordinates, as OpenGL 2.1 recommends (3.8.8): from the
/// longer of the ways, in texels, that a step of a pixel along x or y makes.
std::string OwnLevel(bool cube) {
  std::string text = cube ? "  vec3 size = abs(image_at);\n"
                            "  vec3 at = image_at / max(size.x, max(size.y, size.z)) *\n"
                            "            (0.5 * float(textureSize(image, 0).x));\n"
                          : "  vec2 at = image_at.xy * vec2(textureSize(image, 0));\n";
  return text +
         "  float way = max(dot(dFdx(at), dFdx(at)), dot(dFdy(at), dFdy(at)));\n"
         "  float level = 0.5 * log2(max(way, 1.0));\n";
}

/// The image's colour, from 0 to 255.
std::string Paint(const LitProgramKind& kind) {
  if (kind.image == ImageKind::kNone) return "  vec3 paint = vec3(255.0);\n";
  const bool cube = kind.image == ImageKind::kCube;
  const char* at = cube ? "image_at" : "image_at.xy";
  if (kind.own_levels) {
    return OwnLevel(cube) +
           fmt::format("  vec3 paint = 255.0 * textureLod(image, {}, level).rgb;\n", at);
  }
  return fmt::format("  vec3 paint = 255.0 * {}(image, {}).rgb;\n",
                     cube ? "textureCube" : "texture2D", at);
}

std::string FragmentShader(const LitProgramKind& kind, int shadows) {
  // One pass alone is rounded by the frame buffer, after blending.
  const char* pass = shadows > 0 ? "floor({} * paint + 0.5)" : "{} * paint";
  const auto rounded = [pass](const std::string& light) {
    return fmt::format(fmt::runtime(pass), light);
  };
  std::string text = Version(kind) + "uniform float alpha;\n" + Varyings(kind, shadows);
  if (kind.image == ImageKind::kCube) {
    text += "uniform samplerCube image;\n";
  } else if (kind.image != ImageKind::kNone) {
    text += "uniform sampler2D image;\n";
  }
  for (int k = 0; k < shadows; ++k) text += fmt::format("uniform sampler2DShadow map{};\n", k);
  text += "void main() {\n";
  text += Paint(kind);
  text += fmt::format("  vec3 sum = {};\n", rounded("base"));
  int k = 0;
  for (const LightKind& light : kind.lights) {
    if (!light.shadow) continue;
    const char* lookup = light.directional ? "shadow2D(map{0}, map_at{0}.xyz).r"
                                           : "shadow2DProj(map{0}, map_at{0}).r";
    text += fmt::format("  sum += {} * {};\n", fmt::format(fmt::runtime(lookup), k),
                        rounded(fmt::format("lit{}", k)));
    ++k;
  }
  return text + "  gl_FragColor = vec4(sum / 255.0, alpha);\n}\n";
}

GLuint Compile(const GlFunctions& gl, GLenum type, const std::string& source) {
  const GLuint shader = gl.CreateShader(type);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint compiled = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled) return shader;
  std::string log(1024, '\0');
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  throw RenderError(fmt::format("this OpenGL does not take our shader: {}", log.c_str()));
}

GLuint Link(const GlFunctions& gl, GLuint vertex, GLuint fragment) {
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, vertex);
  gl.AttachShader(program, fragment);
  gl.LinkProgram(program);
  gl.DeleteShader(vertex);
  gl.DeleteShader(fragment);
  GLint linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return program;
  std::string log(1024, '\0');
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteProgram(program);
  throw RenderError(fmt::format("this OpenGL does not link our shader: {}", log.c_str()));
}

}  // namespace

bool FindsOwnLevels(std::string_view gl_renderer) {
  return gl_renderer.find("llvmpipe") == std::string_view::npos;
}

LitProgram::LitProgram(const GlFunctions& gl, const LitProgramKind& kind) : gl_(gl) {
  const auto shadows = static_cast<int>(std::count_if(
      kind.lights.begin(), kind.lights.end(), [](const LightKind& light) { return light.shadow; }));
  const GLuint vertex = Compile(gl, GL_VERTEX_SHADER, VertexShader(kind, shadows));
  program_ = Link(gl, vertex, Compile(gl, GL_FRAGMENT_SHADER, FragmentShader(kind, shadows)));
  gl_.UseProgram(program_);
  alpha_ = gl.GetUniformLocation(program_, "alpha");
  material_ = gl.GetUniformLocation(program_, "material");
  image_scale_ = gl.GetUniformLocation(program_, "image_scale");
  gl.Uniform1i(gl.GetUniformLocation(program_, "image"), 0);
  for (int k = 0; k < shadows; ++k) {
    const auto location = [&](const char* name) {
      return gl.GetUniformLocation(program_, fmt::format("{}{}", name, k).c_str());
    };
    gl.Uniform1i(location("map"), 1 + k);
    shadow_matrices_.push_back(location("map_from_eye"));
  }
}

LitProgram::~LitProgram() { gl_.DeleteProgram(program_); }

void LitProgram::SetShadowMatrix(int k, const float matrix[16]) const {
  gl_.UniformMatrix4fv(shadow_matrices_[static_cast<std::size_t>(k)], 1, GL_FALSE, matrix);
}

}  // namespace horopter::sim
