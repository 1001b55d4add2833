#include "ui/scenes/overlay_shaders.h"

namespace angiopose::ui {
namespace {

// Computes the screen positions, device px, of a point and its neighbors, each with the offset from the centerline to
// the vessel edge.
constexpr const char* lineVertexText = R"(//VTK::System::Dec
//VTK::CustomUniforms::Dec
in vec4 vertexMC;
in vec4 here;
in vec4 before;
in vec3 beforeDirection;
in vec4 after;
in vec3 afterDirection;
in vec3 tone;
in vec4 look;
in vec3 way;
in vec3 wayEnd;
uniform mat4 MCDCMatrix;
out vec4 hereVS;
out vec4 beforeVS;
out vec4 afterVS;
out vec3 seenVS;
out vec3 toneVS;
out vec4 lookVS;
out vec3 wayVS;
out vec3 wayEndVS;

const float nearestMm = 1.0;   // as core::minProjectableDepthMm

vec4 placed(vec3 point, vec3 direction, float radius, out float seen)
{
    vec4 clip = MCDCMatrix * vec4(point, 1.0);
    vec4 ahead = MCDCMatrix * vec4(direction, 0.0);
    seen = clip.w >= nearestMm ? 1.0 : 0.0;
    vec2 at = (0.5 * clip.xy / clip.w + 0.5) * viewport;
    vec2 along = (ahead.xy * clip.w - clip.xy * ahead.w) * viewport;
    float size = length(along);
    vec2 normal = size > 0.0 ? handed * vec2(along.y, -along.x) / size : vec2(0.0);
    return vec4(at, normal * radius * radiusScale / clip.w);
}

vec3 deepened(vec3 color, float depth)
{
    float farness = clamp((depth - nearMm) / spanMm, 0.0, 1.0);
    return farness < 0.5 ? mix(nearTone, color, 0.3 + 1.4 * farness) : mix(color, farTone, 1.5 * (farness - 0.5));
}

void main()
{
    vec4 clip = MCDCMatrix * vertexMC;
    hereVS = placed(vertexMC.xyz, here.xyz, here.w, seenVS.x);
    beforeVS = placed(before.xyz, beforeDirection, before.w, seenVS.y);
    afterVS = placed(after.xyz, afterDirection, after.w, seenVS.z);
    seenVS.y *= before.w < 0.0 ? 0.0 : 1.0;
    seenVS.z *= after.w < 0.0 ? 0.0 : 1.0;
    toneVS = spanMm > 0.0 ? deepened(tone, clip.w) : tone;
    lookVS = look;
    wayVS = way;
    wayEndVS = wayEnd;
    gl_Position = clip;
}
)";

// Expands a line segment to a quad that is as wide as the line with its fade, and longer at ends and round joints.
constexpr const char* lineGeometryText = R"(//VTK::System::Dec
//VTK::CustomUniforms::Dec
layout(lines) in;
layout(triangle_strip, max_vertices = 12) out;
in vec4 hereVS[];
in vec4 beforeVS[];
in vec4 afterVS[];
in vec3 seenVS[];
in vec3 toneVS[];
in vec4 lookVS[];
in vec3 wayVS[];
in vec3 wayEndVS[];
noperspective out vec2 local;   // along the piece and across it, px from its begin
flat out float size;
flat out vec4 joint;   // start and end: 0 goes on, 1 round end, 2 round joint; direction of the piece before, local
flat out vec3 profile;   // solid up to, faded out at, opacity
flat out vec3 startTone;
flat out vec3 endTone;
flat out vec3 ways;   // along the whole line: at start, end, and where the line ends, px
flat out vec2 dash;   // drawn and gap, px

vec2 leftOf(vec2 direction) { return vec2(-direction.y, direction.x); }

vec2 directionFrom(vec2 a, vec2 b)
{
    vec2 step = b - a;
    float size = length(step);
    return size > 1e-5 ? step / size : vec2(1.0, 0.0);
}

vec3 profileOf(float width, float fade, float opacity)
{
    float inner = 0.5 * (width - fade);
    float outer = 0.5 * (width + fade);
    return inner >= 0.0 ? vec3(inner, outer, opacity) : vec3(0.0, outer, opacity * width / outer);
}

void emitAt(vec2 at, vec2 start, vec2 along)
{
    local = vec2(dot(at - start, along), dot(at - start, leftOf(along)));
    gl_Position = vec4(2.0 * at / viewport - 1.0, 0.0, 1.0);
    EmitVertex();
}

void emitDot(vec2 centre, vec3 color, float width, float opacity)
{
    size = 0.0;
    joint = vec4(1.0, 1.0, 0.0, 0.0);
    profile = profileOf(2.3 * width, 1.0, opacity);
    startTone = endTone = color;
    ways = vec3(0.0);
    dash = vec2(0.0);
    float reach = profile.y;
    for (int corner = 0; corner < 4; ++corner) {
        emitAt(centre + reach * vec2(corner < 2 ? -1.0 : 1.0, corner % 2 == 0 ? -1.0 : 1.0), centre, vec2(1.0, 0.0));
    }
    EndPrimitive();
}

void emitPiece(vec2 a, vec2 b, vec2 previous, vec2 next, vec3 way, float width)
{
    vec2 along = directionFrom(a, b);
    vec2 across = leftOf(along);
    size = length(b - a);
    joint = vec4(0.0);
    float fade = fadePx + fadeGain * width;
    profile = profileOf(widthGain * width + widthExtraPx, fade, opacityGain * lookVS[0].y);
    startTone = shade.a > 0.5 ? shade.rgb : toneVS[0];
    endTone = shade.a > 0.5 ? shade.rgb : toneVS[1];
    ways = way * wayScale;
    dash = lookVS[0].z > 0.5 ? dashPx : vec2(0.0);
    vec2 left = across;
    vec2 right = across;
    float outer = profile.y;
    vec2 start = a;
    vec2 end = b;
    if (seenVS[0].y > 0.5) {
        vec2 in_ = directionFrom(previous, a);
        if (dot(in_, along) > 0.5) {
            vec2 middle = normalize(leftOf(in_) + across);
            left = middle / dot(middle, across);
        } else {
            joint = vec4(2.0, 0.0, dot(in_, along), dot(in_, across));
            start -= outer * along;
        }
    } else {
        joint.x = 1.0;
        start -= outer * along;
    }
    if (seenVS[1].z > 0.5) {
        vec2 out_ = directionFrom(b, next);
        if (dot(out_, along) > 0.5) {
            vec2 middle = normalize(leftOf(out_) + across);
            right = middle / dot(middle, across);
        }
    } else {
        joint.y = 1.0;
        end += outer * along;
    }
    vec4 corners = vec4(start + outer * left, start - outer * left);
    emitAt(corners.xy, a, along);
    emitAt(corners.zw, a, along);
    emitAt(end + outer * right, a, along);
    emitAt(end - outer * right, a, along);
    EndPrimitive();
}

void emitInside(vec4 a, vec4 b)
{
    size = length(b.xy - a.xy);
    joint = vec4(0.0);
    profile = vec3(1e6, 2e6, opacityGain * lookVS[0].y);
    startTone = toneVS[0];
    endTone = toneVS[1];
    ways = vec3(0.0);
    dash = vec2(0.0);
    vec2 along = directionFrom(a.xy, b.xy);
    emitAt(a.xy + a.zw, a.xy, along);
    emitAt(a.xy - a.zw, a.xy, along);
    emitAt(b.xy + b.zw, a.xy, along);
    emitAt(b.xy - b.zw, a.xy, along);
    EndPrimitive();
}

void main()
{
    if (seenVS[0].x < 0.5 || seenVS[1].x < 0.5) {
        return;
    }
    bool hasDots = mod(lookVS[0].w, 2.0) > 0.5;
    bool hasEdges = lookVS[0].w > 1.5;
    vec4 a = hereVS[0];
    vec4 b = hereVS[1];
    vec4 previous = beforeVS[0];
    vec4 next = afterVS[1];
    float width = lookVS[0].x * lineWidthPx;
    if (mode == 2) {
        if (hasEdges) {
            emitInside(a, b);
        }
    } else if (mode == 1 && hasEdges) {
        emitPiece(a.xy + a.zw, b.xy + b.zw, previous.xy + previous.zw, next.xy + next.zw, vec3(wayVS[0].x, wayVS[1].x, wayEndVS[0].x), width);
        emitPiece(a.xy - a.zw, b.xy - b.zw, previous.xy - previous.zw, next.xy - next.zw, vec3(wayVS[0].z, wayVS[1].z, wayEndVS[0].z), width);
    } else {
        emitPiece(a.xy, b.xy, previous.xy, next.xy, vec3(wayVS[0].y, wayVS[1].y, wayEndVS[0].y), width);
        if (hasDots && showsDots == 1 && seenVS[0].y < 0.5) {
            emitDot(a.xy, toneVS[0], width, lookVS[0].y);
        }
        if (hasDots && showsDots == 1 && seenVS[1].z < 0.5) {
            emitDot(b.xy, toneVS[1], width, lookVS[0].y);
        }
    }
}
)";

// Selects the pixels inside the cutout; matches applyCutout in cutout.cpp.
constexpr const char* cutoutText = R"(
bool isCutoutEdge = false;

bool isCutOut(vec2 at)
{
    if (cutout.x < 0.5) {
        return false;
    }
    float column = floor(handed > 0.0 ? at.x : viewport.x - at.x);
    float row = viewport.y - at.y - cutout.z;
    float span = cutout.x < 1.5 ? 0.0 : sqrt(max(0.0, cutout.w * cutout.w - row * row));
    float first = floor(clamp(cutout.y - span, 0.0, viewport.x) + 0.5);
    float end = cutout.x < 1.5 ? viewport.x : floor(clamp(cutout.y + span, 0.0, viewport.x) + 0.5);
    isCutoutEdge = column == first || (cutout.x > 1.5 && column == end - 1.0);
    return column >= first && column < end;
}
)";

constexpr const char* lineHeadText = R"(//VTK::System::Dec
//VTK::Output::Dec
//VTK::CustomUniforms::Dec
noperspective in vec2 local;
flat in float size;
flat in vec4 joint;
flat in vec3 profile;
flat in vec3 startTone;
flat in vec3 endTone;
flat in vec3 ways;
flat in vec2 dash;
)";

constexpr const char* lineMainText = R"(
void main()
{
    if (isCutOut(gl_FragCoord.xy)) {
        discard;
    }
    float beyond = 0.0;   // the piece's begin or end
    if (joint.x > 0.5 && local.x < 0.0) {
        if (joint.x > 1.5 && dot(local, joint.zw) < 0.0) {
            discard;   // the piece before covers it
        }
        beyond = -local.x;
    } else if (joint.y > 0.5 && local.x > size) {
        beyond = local.x - size;
    }
    float share = clamp(local.x / max(size, 1e-6), 0.0, 1.0);
    if (dash.x + dash.y > 0.0) {
        float way = mix(ways.x, ways.y, share);
        float place = mod(way, dash.x + dash.y);
        float toNext = dash.x + dash.y - place;
        if (way + toNext > ways.z) {
            toNext = 1e6;   // the line ends before
        }
        beyond += place <= dash.x ? 0.0 : min(place - dash.x, toNext);
    }
    float aside = length(vec2(beyond, local.y));
    float cover = clamp((profile.y - aside) / (profile.y - profile.x), 0.0, 1.0);
    gl_FragData[0] = vec4(mix(startTone, endTone, share), cover * profile.z * opacity);
}
)";

constexpr const char* frameVertexText = R"(//VTK::System::Dec
in vec4 vertexMC;
void main()
{
    gl_Position = vec4(vertexMC.xy, 0.999, 1.0);
}
)";

constexpr const char* frameHeadText = R"(//VTK::System::Dec
//VTK::Output::Dec
//VTK::CustomUniforms::Dec
uniform sampler2D frame;
uniform sampler2D radiograph;
)";

constexpr const char* frameMainText = R"(
float greyAt(ivec2 pixel)
{
    return floor(255.0 * texelFetch(frame, pixel, 0).r + 0.5);
}

// A tent as wide as a pixel of the screen or, when that is smaller, of the frame.
float smoothGrey(vec2 place, vec2 reach)
{
    vec2 inside = clamp(place, vec2(0.0), frameSize - 1.0);
    ivec2 first = max(ivec2(0), ivec2(floor(inside - reach)) + 1);
    ivec2 last = min(ivec2(frameSize) - 1, ivec2(ceil(inside + reach)) - 1);
    float sum = 0.0;
    float weights = 0.0;
    for (int y = first.y; y <= last.y; ++y) {
        for (int x = first.x; x <= last.x; ++x) {
            vec2 tent = 1.0 - abs(vec2(x, y) - inside) / reach;
            sum += tent.x * tent.y * greyAt(ivec2(x, y));
            weights += tent.x * tent.y;
        }
    }
    return sum / weights;
}

float tintAt(vec2 place)
{
    vec2 count = vec2(textureSize(radiograph, 0));
    vec2 at = clamp((place + 0.5) / frameSize * count - 0.5, vec2(0.0), count - 1.0);
    ivec2 first = ivec2(at);
    ivec2 second = min(first + 1, ivec2(count) - 1);
    vec2 share = at - vec2(first);
    float above = mix(texelFetch(radiograph, first, 0).r, texelFetch(radiograph, ivec2(second.x, first.y), 0).r, share.x);
    float below = mix(texelFetch(radiograph, ivec2(first.x, second.y), 0).r, texelFetch(radiograph, second, 0).r, share.x);
    return mix(above, below, share.y);
}

void main()
{
    vec2 fraction = vec2(gl_FragCoord.x, viewport.y - gl_FragCoord.y) / viewport;
    vec2 place = part.xz + fraction * (part.yw - part.xz);
    vec3 color = around;
    bool isInside = all(greaterThanEqual(place, vec2(-0.5))) && all(lessThanEqual(place, frameSize - 0.5));
    if (isInside) {
        vec2 reach = max(vec2(1.0), abs(part.yw - part.xz) / viewport);
        vec2 nearest = clamp(floor(place + 0.5), vec2(0.0), frameSize - 1.0);
        float grey = isSmooth == 1 ? floor(smoothGrey(place, reach) + 0.5) : greyAt(ivec2(nearest));
        color = vec3(grey / 255.0);
    }
    if (isCutOut(gl_FragCoord.xy)) {
        color = isCutoutEdge ? edgeTone : color;
    } else if (tintDepth > 0.0 && isInside) {
        float share = tintDepth * tintAt(place);
        color = share > 0.002 ? mix(color, tintTone, share) : color;
    }
    gl_FragData[0] = vec4(color, 1.0);
}
)";

}   // namespace

const ShaderSources& lineShaders()
{
    static const ShaderSources texts{lineVertexText, lineGeometryText,
                                     std::string(lineHeadText) + cutoutText + lineMainText};
    return texts;
}

const ShaderSources& frameShaders()
{
    static const ShaderSources texts{frameVertexText, "", std::string(frameHeadText) + cutoutText + frameMainText};
    return texts;
}

}   // namespace angiopose::ui
