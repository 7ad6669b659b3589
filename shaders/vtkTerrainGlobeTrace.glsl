// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Exact ray casting at a globe. Needs vtkTerrainGlobeLines.glsl and vtkTerrainPyramid.glsl.
//
// Twins in src/core/: globe/GlobeTraversal.h, step for step, which documents the method;
// globe/GlobeRoot.h, globe/GlobePixels.h.

const float terrainGlobeNever = 1e30; // a distance beyond any
// Metres from a hit to where a ray goes on behind it: more than float rounds of a planet's radius.
const float terrainGlobeBeyond = 10.0;

// A ray with what its lines share: metres in the axes of the anchor. Every t below is a distance
// along it, in units of the direction's length.
struct TerrainGlobePath
{
  vec3 origin;    // x from the axis, metres
  vec3 direction; // metres a unit of t
  vec3 squares;   // (r^2 - radius^2) = x + 2 t y + t^2 z, square metres; r: distance from the axis
  bool east;      // goes round the axis to the east
  float sag;      // second derivative by t that heights cannot exceed, metres
  float begin;    // searched is begin <= t <= end
  float end;
};

// Where a ray is: the node of the pyramid that it runs on in.
struct TerrainGlobeStep
{
  ivec2 node; // column, -1 in the gap of a partial raster; row, -1 south of it and -2 north
  int level;  // nodes have 2^level x 2^level cells
  float t;
};

// The part of a ray in a node.
struct TerrainGlobeSpan
{
  float t;    // where it leaves
  int side;   // 0 across a meridian, 1 north, 2 south
  bool ends;  // the ray ends in the node
};

struct TerrainGlobeHit
{
  bool found;
  float t;
  ivec2 cell;    // column and row of its south-west sample
  vec2 fraction; // in the cell, 0 to 1 east and north
  bool front;    // seen from above
  int crossings; // nodes and cells that the ray came through
};

// A path with its t from begin to end; o: origin, relative to the anchor, and d: direction, in
// metres.
TerrainGlobePath terrainGlobeMakePath(vec3 o, vec3 d, float begin, float end)
{
  TerrainGlobePath path;
  float radius = terrainGlobeScene.x;
  path.origin = vec3(radius + o.x, o.yz);
  path.direction = d;
  path.squares = vec3((radius + path.origin.x) * o.x + o.y * o.y,
    path.origin.x * d.x + o.y * d.y, d.x * d.x + d.y * d.y);
  path.east = path.origin.x * d.y - o.y * d.x >= 0.0;
  path.sag = terrainGlobeScene.w * (path.squares.z + d.z * d.z);
  path.begin = begin;
  path.end = end;
  return path;
}

// Distances t at which a path meets a shell, the xyz of terrainGlobeOuter or terrainGlobeInner;
// x > y if it does not.
vec2 terrainGlobeMeetShell(TerrainGlobePath path, vec3 shell)
{
  float z = path.origin.z;
  float dz = path.direction.z;
  float c = shell.z + path.squares.x * shell.x + z * (2.0 * terrainGlobeScene.y + z) * shell.y;
  float b = path.squares.y * shell.x + (terrainGlobeScene.y + z) * dz * shell.y;
  float a = path.squares.z * shell.x + dz * dz * shell.y;
  float discriminant = b * b - a * c;
  if (!(discriminant > 0.0))
  {
    return vec2(1.0, 0.0);
  }
  float q = b < 0.0 ? sqrt(discriminant) - b : -sqrt(discriminant) - b;
  return vec2(min(q / a, c / q), max(q / a, c / q));
}

// How much farther from the axis than the anchor a path is at t, metres.
float terrainGlobeOffAxis(TerrainGlobePath path, float t)
{
  vec2 at = path.origin.xy + t * path.direction.xy;
  float squares = path.squares.x + t * (2.0 * path.squares.y + t * path.squares.z);
  return squares / max(length(at) + terrainGlobeScene.x, 1e-20);
}

// Distance of a path at t north of the cone of a parallel's normals, in metres; row: of the
// parallel; off: terrainGlobeOffAxis(). Equations: src/core/globe/GlobeAnchor.h.
float terrainGlobeNorth(TerrainGlobePath path, vec4 row, float t, float off)
{
  return row.z + (path.origin.z + t * path.direction.z) * row.y - off * row.x;
}

// Distance above the plane that touches the ellipsoid at the parallel, less the anchor's, in
// metres.
float terrainGlobeAbove(TerrainGlobePath path, vec4 row, float t, float off)
{
  return row.w + (path.origin.z + t * path.direction.z) * row.x + off * row.y;
}

// Distance of a path at t east of a meridian's plane, and along it from the axis, in metres;
// column: terrainGlobeColumnAt().
vec2 terrainGlobeEast(TerrainGlobePath path, vec2 column, float t)
{
  vec2 at = path.origin.xy + t * path.direction.xy;
  return vec2(at.y * column.y - at.x * column.x, at.x * column.y + at.y * column.x);
}

// Distance t, of any sign, at which a path crosses a meridian in its own direction;
// terrainGlobeNever if it does not. column: terrainGlobeColumnAt().
float terrainGlobeColumnCrossing(TerrainGlobePath path, vec2 column)
{
  float east = path.origin.y * column.y - path.origin.x * column.x;
  float change = path.direction.y * column.y - path.direction.x * column.x;
  return (path.east ? change > 0.0 : change < 0.0) ? -east / change : terrainGlobeNever;
}

// Distance, t or more, at which a path crosses a parallel to the north, or to the south;
// terrainGlobeNever if it does not. row: terrainGlobeRowAt(). RowCrossing() of the twin has the
// equation.
float terrainGlobeRowCrossing(TerrainGlobePath path, vec4 row, float t, bool north)
{
  float s = row.x;
  float radius = terrainGlobeScene.x;
  vec3 m = path.squares;
  float g = row.z + path.origin.z * row.y;
  float k = path.direction.z * row.y;
  float a = k * k - s * s * m.z;
  float inner1 = radius * k - s * m.y;
  float inner2 = 2.0 * radius * g - s * m.x;
  float b = g * k + s * inner1;
  float c = g * g + s * inner2;
  float inner = inner1 * inner1 + k * (k * m.x - 2.0 * g * m.y) + m.z * (g * g + s * inner2);
  bool towardsPole = north == (s > 0.0);
  bool never = row.y == 0.0 ||
    (a >= 0.0 ? !(north ? k > 0.0 : k < 0.0) : towardsPole && !(inner > 0.0));
  float root = (north ? s : -s) * sqrt(max(inner, 0.0));
  float sum = root - b;
  float rest = -root - b;
  float at = abs(sum) >= abs(rest) ? sum / a : c / rest;
  bool far = a < 0.0 &&
    ((radius * s + g - k * (b / a)) * s < 0.0 || (towardsPole && a * t + b < 0.0));
  return never || far ? terrainGlobeNever : max(at, t);
}

// The first and the last lines of a node, in samples: west, south, east, north.
ivec4 terrainGlobeFence(TerrainGlobeStep at)
{
  ivec2 first = at.node << at.level;
  return ivec4(first, min(first + (1 << at.level), terrainSize - 1));
}

// The coarsest level that is stepped through.
int terrainGlobeTop()
{
  return min(terrainGlobeGrid.y, terrainPyramidTop);
}

// The coarsest node that a path is in at t.
TerrainGlobeStep terrainGlobeFirstStep(TerrainGlobePath path, float t)
{
  ivec2 cells = terrainSize - 1;
  TerrainGlobeStep at = TerrainGlobeStep(ivec2(-1), terrainGlobeTop(), t);
  vec2 position = path.origin.xy + t * path.direction.xy;
  float column = terrainGlobeColumn.z +
    atan(position.y, position.x) * terrainGlobeColumn.x + float(terrainGlobeGrid.x);
  column -= terrainGlobeColumn.y * floor(column / terrainGlobeColumn.y);
  int cell = int(column);
  if (cell < cells.x || terrainGlobeJoined == 1)
  {
    at.node.x = min(cell, cells.x - 1) >> at.level;
  }
  float off = terrainGlobeOffAxis(path, t);
  vec4 last = terrainGlobeRowAt(cells.y);
  if (terrainGlobeNorth(path, last, t, off) > 0.0 && last.y > 0.0)
  {
    at.node.y = -2;
    return at;
  }
  bool up = true;
  while (up && ((at.node.y + 1) << at.level) < cells.y)
  {
    vec4 row = terrainGlobeRowAt((at.node.y + 1) << at.level);
    up = terrainGlobeNorth(path, row, t, off) >= 0.0 || row.y == 0.0;
    at.node.y += up ? 1 : 0;
  }
  return at;
}

// The part of a path, from at.t on, in a node; fence: terrainGlobeFence() of it.
TerrainGlobeSpan terrainGlobeNodeSpan(TerrainGlobePath path, TerrainGlobeStep at, ivec4 fence)
{
  ivec2 cells = terrainSize - 1;
  TerrainGlobeSpan span = TerrainGlobeSpan(terrainGlobeNever, 0, false);
  bool inside = at.node.x >= 0;
  vec2 line = terrainGlobeColumnAt(
    inside ? (path.east ? fence.z : fence.x) : (path.east ? 0 : cells.x));
  float east = inside ? 0.0 : terrainGlobeEast(path, line, at.t).x;
  bool ahead = inside || (path.east ? east < 0.0 : east > 0.0);
  span.t = max(ahead ? terrainGlobeColumnCrossing(path, line) : terrainGlobeNever, at.t);
  if (at.node.y != -2)
  {
    vec4 row = terrainGlobeRowAt(at.node.y >= 0 ? fence.w : 0);
    float north = terrainGlobeRowCrossing(path, row, at.t, true);
    span.side = north < span.t ? 1 : span.side;
    span.t = min(span.t, north);
  }
  if (at.node.y != -1)
  {
    vec4 row = terrainGlobeRowAt(at.node.y >= 0 ? fence.y : cells.y);
    float south = terrainGlobeRowCrossing(path, row, at.t, false);
    span.side = south < span.t ? 2 : span.side;
    span.t = min(span.t, south);
  }
  span.ends = span.t >= path.end;
  span.t = min(span.t, path.end);
  return span;
}

// The node that a path comes to where it leaves one; a level coarser where that line bounds coarser
// nodes, too.
TerrainGlobeStep terrainGlobeAcross(
  TerrainGlobePath path, TerrainGlobeStep at, TerrainGlobeSpan span, ivec4 fence)
{
  ivec2 cells = terrainSize - 1;
  TerrainGlobeStep next = TerrainGlobeStep(at.node, at.level, span.t);
  int line;
  if (span.side == 0)
  {
    bool inside = at.node.x >= 0;
    line = inside ? (path.east ? fence.z : fence.x) : (path.east ? 0 : cells.x);
    bool border = inside && line == (path.east ? cells.x : 0);
    line = border && terrainGlobeJoined == 1 ? cells.x - line : line;
    next.node.x =
      border && terrainGlobeJoined == 0 ? -1 : (path.east ? line : line - 1) >> at.level;
  }
  else
  {
    bool north = span.side == 1;
    bool inside = at.node.y >= 0;
    line = inside ? (north ? fence.w : fence.y) : (north ? 0 : cells.y);
    bool border = inside && line == (north ? cells.y : 0);
    next.node.y = border ? (north ? -2 : -1) : (north ? line : line - 1) >> at.level;
  }
  if (((line >> at.level) & 1) == 0 && at.level < terrainGlobeTop())
  {
    next.node = ivec2(next.node.x < 0 ? next.node.x : next.node.x >> 1,
      next.node.y < 0 ? next.node.y : next.node.y >> 1);
    ++next.level;
  }
  return next;
}

// The one of a node's four children that a path is in at t.
TerrainGlobeStep terrainGlobeDown(TerrainGlobePath path, TerrainGlobeStep at, float t)
{
  TerrainGlobeStep next = TerrainGlobeStep(at.node << 1, at.level - 1, t);
  ivec2 middle = (next.node + 1) << next.level;
  ivec2 line = min(middle, terrainSize - 1);
  bool east = terrainGlobeEast(path, terrainGlobeColumnAt(line.x), t).x >= 0.0;
  bool north =
    terrainGlobeNorth(path, terrainGlobeRowAt(line.y), t, terrainGlobeOffAxis(path, t)) >= 0.0;
  next.node += ivec2(east && middle.x < terrainSize.x - 1 ? 1 : 0,
    north && middle.y < terrainSize.y - 1 ? 1 : 0);
  return next;
}

// Least and greatest height that a path may have at t, less the anchor's, metres, from the circle
// at a row; line: terrainGlobeRowAt(), radius: of the circle, metres.
vec2 terrainGlobeHeightNear(TerrainGlobePath path, vec4 line, float radius, float t)
{
  float off = terrainGlobeOffAxis(path, t);
  float north = terrainGlobeNorth(path, line, t, off);
  float above = terrainGlobeAbove(path, line, t, off);
  radius += terrainGlobeScene.z + above;
  float drop = north * north / (sqrt(north * north + radius * radius) + radius);
  float rounding = 4.8e-7 *
    (abs(off) + abs(line.w) + abs(path.origin.z + t * path.direction.z) +
      abs(t) * dot(abs(path.direction), vec3(1.0)));
  float slack = terrainGlobeOuter.w * drop + rounding;
  return vec2(above + drop - slack, above + drop + slack);
}

// True if a path may meet a node between at.t and span.t; then from is the t where from, and side
// as in terrainGlobeMeetCell(). row: a row of samples in the node, from whose circle heights are
// taken.
bool terrainGlobeVisitNode(
  TerrainGlobePath path, TerrainGlobeStep at, TerrainGlobeSpan span, int row, out float from,
  inout float side)
{
  vec2 bounds = terrainGlobeHeights.y +
    terrainGlobeHeights.x * (terrainNodeExtremes(at.node, at.level) - terrainGlobeHeights.z);
  vec4 line = terrainGlobeRowAt(row);
  float radius = terrainGlobeCurveAt(row).x;
  vec2 begin = terrainGlobeHeightNear(path, line, radius, at.t);
  vec2 end = terrainGlobeHeightNear(path, line, radius, span.t);
  float length = span.t - at.t;
  float change = end.x - begin.x;
  float sag = 0.5 * path.sag * length * length;
  float least = abs(change) < sag
    ? begin.x + 0.5 * change - 0.25 * (sag + change * change / sag)
    : min(begin.x, end.x);
  float fall = begin.x > bounds.x ? (begin.x - bounds.x) / (sag - change) : 0.0;
  float rise = begin.y < bounds.y ? (bounds.y - begin.y) / (end.y - begin.y) : 0.0;
  // rounded past flat ground that the path came to from the other side
  bool through = (side > 0.0 && begin.y < bounds.y) || (side < 0.0 && begin.x > bounds.x);
  from = at.t + (through ? 0.0 : min(max(max(fall, rise), 0.0), 1.0) * length);
  side = through ? side : begin.x > bounds.x ? 1.0 : begin.y < bounds.y ? -1.0 : side;
  return through || (least <= bounds.x && max(begin.y, end.y) >= bounds.y);
}

// atan(x), radians, of the angles in a cell, which are small: to kGlobeAngleError
// (core/globe/GlobeErrors.h) up to 2.5 degrees, and beyond as the driver has it.
float terrainGlobeAngle(float x)
{
  float x2 = x * x;
  return x2 < 2e-3 ? x * (1.0 - x2 * (1.0 / 3.0 - x2 * 0.2)) : atan(x);
}

// Height of a path at t in a cell less that of the surface, in metres, and the position in the
// cell, 0..1. Codes: of the cell's corners, less the anchor's.
float terrainGlobeDifference(
  TerrainGlobePath path, ivec2 cell, vec4 codes, float t, out vec2 fraction)
{
  vec4 line = terrainGlobeRowAt(cell.y);
  vec4 curve = terrainGlobeCurveAt(cell.y);
  float off = terrainGlobeOffAxis(path, t);
  float north = terrainGlobeNorth(path, line, t, off);
  float above = terrainGlobeAbove(path, line, t, off);
  float radius = curve.x + terrainGlobeScene.z + above;
  vec2 move = vec2(0.0);
  float d = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    d = terrainGlobeAngle((north - move.x) / (radius - move.y));
    move = vec2(d * d * (curve.y * (0.5 - 0.125 * d * d) + curve.z * d * (1.0 / 6.0)),
      -d * d * d * (curve.y * (1.0 / 3.0) + curve.z * d * 0.125));
  }
  vec2 foot = vec2(north - move.x, radius - move.y);
  float height = above - move.y + foot.x * foot.x / (length(foot) + foot.y);
  vec2 east = terrainGlobeEast(path, terrainGlobeColumnAt(cell.x), t);
  fraction = clamp(vec2(terrainGlobeAngle(east.x / max(east.y, 1e-20)) * terrainGlobeColumn.x,
    d * curve.w), vec2(0.0), vec2(1.0));
  return height - terrainGlobeHeights.y - terrainGlobeHeights.x * terrainPatchCode(codes, fraction);
}

// How a path meets a cell: the first root of a parabola through its differences in height.
struct TerrainGlobeMeeting
{
  float begin;  // t where the path comes into the cell
  float length; // t from there to where it leaves
  float a;      // of the parabola a p^2 + b p + c, metres; p: part of the way, 0 to 1
  float b;
  float c;
  float part;   // its first root, < 0 for none
  bool between; // on the line where the path comes in
  bool front;   // seen from above
};

// Errors of distances in metres, and as a part of them: kGlobeFloatError, kGlobeFloatPartError
// (core/globe/GlobeErrors.h).
const float terrainGlobeFloatError = 0.01;
const float terrainGlobeFloatPartError = 1e-5;

// Difference at a root, in metres, that is near enough.
float terrainGlobeEnoughAt(float t)
{
  return terrainGlobeFloatError + terrainGlobeFloatPartError * abs(t);
}

// The meeting of a path with the cell at at.node, from at.t to end; side: the sign of the
// difference where the path left the cell before, 0 if not known.
TerrainGlobeMeeting terrainGlobeMeetCell(
  TerrainGlobePath path, TerrainGlobeStep at, float end, inout float side)
{
  vec4 codes = terrainCellCodes(at.node);
  bool valid = terrainCellValid(codes);
  codes -= terrainGlobeHeights.z;
  float length = end - at.t;
  float values[3];
  vec2 fraction;
  // a loop, so that the function stands in the program once
  for (int i = 0; i < 3; ++i)
  {
    values[i] =
      terrainGlobeDifference(path, at.node, codes, at.t + 0.5 * float(i) * length, fraction);
  }
  bool between = side * values[0] < 0.0;
  float a = 2.0 * (values[0] + values[2] - 2.0 * values[1]);
  float b = values[2] - values[0] - a;
  float t = between ? 0.0 : terrainFirstRoot(values[0], values[2], a);
  bool above = side != 0.0 ? side > 0.0 : values[0] > 0.0 || (values[0] == 0.0 && b <= 0.0);
  side = valid ? sign(values[2]) : 0.0;
  return TerrainGlobeMeeting(at.t, length, a, b, values[0], valid ? t : -1.0, between, above);
}

// Differences that are looked at for a root at most, and parts that a path is followed in.
const int terrainGlobeSteps = 16;

// The hit where a path meets a cell, its root, 0 or more, refined: twice by the parabola, then,
// where meridians are close to each other, by secants between two parts on different sides. None
// where only the parabola dips through the surface; then t is where the path leaves the cell.
TerrainGlobeHit terrainGlobeRefine(TerrainGlobePath path, ivec2 cell, TerrainGlobeMeeting meeting)
{
  vec4 codes = terrainCellCodes(cell) - terrainGlobeHeights.z;
  vec2 fraction;
  float t = meeting.part;
  bool isCrossed = meeting.c * (meeting.a + meeting.b + meeting.c) < 0.0;
  vec2 bracket = vec2(0.0, 1.0); // between them the difference changes sign then
  vec2 last = vec2(0.0);         // the part before, and the difference there
  bool found = true;
  bool ended = false;
  for (int i = 0; i < terrainGlobeSteps && !ended; ++i)
  {
    float at = meeting.begin + t * meeting.length;
    float off = terrainGlobeDifference(path, cell, codes, at, fraction);
    bool isBelow = off * meeting.c <= 0.0;
    isCrossed = isCrossed || isBelow;
    bracket = isBelow ? vec2(t > bracket.x ? bracket.x : 0.0, min(bracket.y, t))
                      : vec2(t < bracket.y ? max(bracket.x, t) : bracket.x, bracket.y);
    float slope = i < 2 ? meeting.b + 2.0 * meeting.a * t : (off - last.y) / (t - last.x);
    float move = abs(slope) > 0.0 ? -off / slope : 2.0; // 2: out of the cell
    bool isInside = t + move > bracket.x && t + move < bracket.y;
    found = meeting.between || isCrossed || abs(off) <= terrainGlobeEnoughAt(at);
    bool isNear = abs(off) <= terrainGlobeEnoughAt(at) ||
      abs(move) * meeting.length <= 4.7683716e-7 * abs(at); // 4 ulps
    ended = meeting.between || !(isInside || isCrossed) || (isNear && (i >= 2 || !isInside)) ||
      i == terrainGlobeSteps - 1;
    last = vec2(t, off);
    t = ended ? t : isInside ? t + move : 0.5 * (bracket.x + bracket.y);
  }
  return TerrainGlobeHit(found, meeting.begin + (found ? t : 1.0) * meeting.length, cell, fraction,
    meeting.front, 0);
}

// True for nodes, and for what lies outside of a partial raster: what is passed as a whole.
bool terrainGlobeIsWide(TerrainGlobeStep at)
{
  return at.level > 0 || at.node.x < 0 || at.node.y < 0;
}

// The first point of the surface on a path between path.begin and path.end, all of it within the
// shells. Where there is none, t is 0, or beyond path.begin where the path is to go on. Two loops
// in turn, as in terrainTracePyramidWithin(): what a cell takes is not done for each node.
TerrainGlobeHit terrainGlobeTracePart(TerrainGlobePath path)
{
  TerrainGlobeHit hit = TerrainGlobeHit(false, 0.0, ivec2(0), vec2(0.0), true, 0);
  vec2 begin = path.origin.xy + path.begin * path.direction.xy;
  // on the axis a path is on all meridians, a millimetre on it is beside one
  float off = begin == vec2(0.0) ? 1e-3 / length(path.direction) : 0.0;
  TerrainGlobeStep at = terrainGlobeFirstStep(path, path.begin + off);
  TerrainGlobeMeeting meeting;
  ivec2 cell = ivec2(0);
  int most = 8 * (terrainSize.x + terrainSize.y) + 64;
  float side = 0.0;
  bool ended = false;
  bool found = false;
  int crossings = 0;
  do
  {
    do
    {
      if (!ended && terrainGlobeIsWide(at))
      {
        ++crossings;
        ivec4 fence = terrainGlobeFence(at);
        TerrainGlobeSpan span = terrainGlobeNodeSpan(path, at, fence);
        float from = at.t;
        bool down = at.node.x >= 0 && at.node.y >= 0 &&
          terrainGlobeVisitNode(path, at, span, (fence.y + fence.w) >> 1, from, side);
        side = down ? side : 0.0;
        ended = (span.ends && !down) || crossings >= most;
        if (down)
        {
          at = terrainGlobeDown(path, at, from);
        }
        else
        {
          at = terrainGlobeAcross(path, at, span, fence);
        }
      }
    } while (!ended && terrainGlobeIsWide(at));
    do
    {
      if (!ended && !terrainGlobeIsWide(at))
      {
        ++crossings;
        ivec4 fence = terrainGlobeFence(at);
        TerrainGlobeSpan span = terrainGlobeNodeSpan(path, at, fence);
        meeting = terrainGlobeMeetCell(path, at, span.t, side);
        cell = at.node;
        found = meeting.part >= 0.0;
        ended = found || span.ends || crossings >= most;
        at = terrainGlobeAcross(path, at, span, fence);
      }
    } while (!ended && !terrainGlobeIsWide(at));
  } while (!ended);
  if (found)
  {
    hit = terrainGlobeRefine(path, cell, meeting);
  }
  hit.crossings = crossings;
  return hit;
}

// The first point of the surface on a ray: origin relative to the anchor, metres; direction, metres
// a unit of t; t from begin to end.
TerrainGlobeHit terrainGlobeTrace(vec3 origin, vec3 direction, float begin, float end)
{
  TerrainGlobeHit hit = TerrainGlobeHit(false, 0.0, ivec2(0), vec2(0.0), true, 0);
  TerrainGlobePath path = terrainGlobeMakePath(origin, direction, begin, end);
  vec2 outer = terrainGlobeMeetShell(path, terrainGlobeOuter.xyz);
  if (!(outer.x < outer.y) || terrainPyramidTop < 1)
  {
    return hit;
  }
  vec2 inner = terrainGlobeMeetShell(path, terrainGlobeInner.xyz);
  bool dives = inner.x < inner.y;
  vec2 begins = vec2(max(begin, outer.x), max(max(begin, outer.x), inner.y));
  vec2 ends = vec2(min(end, dives ? inner.x : outer.y), min(end, outer.y));
  int crossings = 0;
  int part = 0;
  path.begin = begins[0];
  for (int i = 0; i < terrainGlobeSteps && part < 2; ++i)
  {
    path.end = ends[part];
    bool goesOn = false;
    if (path.begin < path.end)
    {
      hit = terrainGlobeTracePart(path);
      crossings += hit.crossings;
      goesOn = !hit.found && hit.t > path.begin;
    }
    part += goesOn ? 0 : hit.found || !dives ? 2 : 1;
    path.begin = goesOn ? hit.t : begins[1];
  }
  hit.crossings = crossings;
  return hit;
}

// The first hit of a pixel's ray between two distances along the viewing direction, whether it is
// seen from above, and the codes of its cell's corners; hit.s counts from range.x
// (terrainTraceRange() in vtkTerrainCast.glsl). Far from the anchor a ray is taken from where it
// comes to the shell, in double precision.
TerrainHit terrainGlobeTraceRange(vec2 pixel, vec2 range, out bool front, out vec4 codes)
{
  vec3 direction = vec3(terrainPixelDirection(pixel));
  vec3 origin = vec3(terrainPixelOrigin(pixel));
  vec2 outer = terrainGlobeMeetShell(
    terrainGlobeMakePath(origin, direction, range.x, range.y), terrainGlobeOuter.xyz);
  TerrainHit hit = terrainNoHit();
  front = true;
  codes = vec4(0.0);
  if (outer.x < outer.y && outer.y > range.x && outer.x < range.y)
  {
    float start = max(range.x, outer.x - 1e-5 * abs(outer.x));
    origin = vec3(terrainPixelOrigin(pixel) + terrainReal(start) * terrainPixelDirection(pixel));
    TerrainGlobeHit found = terrainGlobeTrace(origin, direction, 0.0, range.y - start);
    hit = TerrainHit(
      found.found, found.t + start - range.x, found.cell, found.fraction, found.crossings);
    front = found.front;
    codes = terrainCellCodes(found.cell);
  }
  return hit;
}
