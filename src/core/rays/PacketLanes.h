// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Rays against a heightfield, one a lane (Lanes.h). The steps are those of
 * core/rays/PyramidTraversal.h: each lane goes through the pyramid on its own, in step with the
 * others.
 */
#ifndef terrain_PacketLanes_h
#define terrain_PacketLanes_h

#include "core/grid/Lanes.h"
#include "core/rays/LaneKernels.h"

namespace terrain
{
inline namespace TERRAIN_LANES_KIND
{
/// FloatSamples: samples are floats, -1 for no data; else 16-bit codes that all have a height.
template <bool FloatSamples>
class PacketLanes
{
public:
  using L = Lanes<float>;
  using Value = L::Value;
  using Mask = L::Mask;

  explicit PacketLanes(const PacketGrid& grid)
    : Grid(grid)
  {
  }

  /// Casts the rays first, first + 1, ... of a packet.
  TERRAIN_LANES_INLINE void Cast(const PacketRays& rays, int first, PacketHits& hits)
  {
    this->Aim(rays, first);
    this->Enter();
    this->Search();
    L::Store(this->HitDistance, hits.Distance + first);
    StoreWhole(this->HitX, hits.CellX + first);
    StoreWhole(this->HitY, hits.CellY + first);
    L::Store(this->FractionX, hits.FractionX + first);
    L::Store(this->FractionY, hits.FractionY + first);
    L::Store(this->SlopeX, hits.SlopeX + first);
    L::Store(this->SlopeY, hits.SlopeY + first);
  }

private:
  static constexpr float Still = 1e20f;     ///< inverse of a direction without motion
  static constexpr float StillLine = -1e8f; ///< so that no line is ever reached

  TERRAIN_LANES_INLINE static Value Least(Value a, Value b)
  {
#if defined(__AVX512F__)
    return (Value)_mm512_maskz_min_ps((__mmask16)-1, (__m512)a, (__m512)b);
#elif defined(__AVX2__)
    return (Value)_mm256_min_ps((__m256)a, (__m256)b);
#else
    return a < b ? a : b;
#endif
  }
  TERRAIN_LANES_INLINE static Value Most(Value a, Value b)
  {
#if defined(__AVX512F__)
    return (Value)_mm512_maskz_max_ps((__mmask16)-1, (__m512)a, (__m512)b);
#elif defined(__AVX2__)
    return (Value)_mm256_max_ps((__m256)a, (__m256)b);
#else
    return a > b ? a : b;
#endif
  }
  TERRAIN_LANES_INLINE static Mask Least(Mask a, Mask b)
  {
#if defined(__AVX512F__)
    return (Mask)_mm512_maskz_min_epi32((__mmask16)-1, (__m512i)a, (__m512i)b);
#elif defined(__AVX2__)
    return (Mask)_mm256_min_epi32((__m256i)a, (__m256i)b);
#else
    return a < b ? a : b;
#endif
  }
  TERRAIN_LANES_INLINE static Mask Most(Mask a, Mask b)
  {
#if defined(__AVX512F__)
    return (Mask)_mm512_maskz_max_epi32((__mmask16)-1, (__m512i)a, (__m512i)b);
#elif defined(__AVX2__)
    return (Mask)_mm256_max_epi32((__m256i)a, (__m256i)b);
#else
    return a > b ? a : b;
#endif
  }
  TERRAIN_LANES_INLINE static Value Root(Value a)
  {
#if defined(__AVX512F__)
    return (Value)_mm512_maskz_sqrt_ps((__mmask16)-1, (__m512)a);
#elif defined(__AVX2__)
    return (Value)_mm256_sqrt_ps((__m256)a);
#else
    return L::Root(a);
#endif
  }
  TERRAIN_LANES_INLINE static Value ToFloat(Mask a)
  {
    return __builtin_convertvector(a, Value);
  }
  TERRAIN_LANES_INLINE static Mask FloorToWhole(Value a)
  {
#if defined(__AVX512F__)
    return (Mask)_mm512_maskz_cvt_roundps_epi32(
      (__mmask16)-1, (__m512)a, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC);
#elif defined(__AVX2__)
    return (Mask)_mm256_cvtps_epi32(_mm256_floor_ps((__m256)a));
#else
    const Mask whole = __builtin_convertvector(a, Mask);
    return whole + (ToFloat(whole) > a);
#endif
  }
  TERRAIN_LANES_INLINE static Value Clamp01(Value a)
  {
    return Least(Most(a, Value{}), L::All(1.0f));
  }
  TERRAIN_LANES_INLINE static Value Magnitude(Value a)
  {
    return Most(a, -a);
  }
  TERRAIN_LANES_INLINE static Mask AllWhole(std::int32_t a)
  {
    return a - Mask{};
  }
  TERRAIN_LANES_INLINE static void StoreWhole(Mask value, std::int32_t* to)
  {
    __builtin_memcpy(to, &value, sizeof(value));
  }

  TERRAIN_LANES_INLINE static Mask LoadWhole(const std::int32_t* from)
  {
    Mask value;
    __builtin_memcpy(&value, from, sizeof(value));
    return value;
  }

  /// 32 bits at index * Size bytes, where lanes are chosen; else 0.
  template <int Size>
  TERRAIN_LANES_INLINE static Mask Gather(const void* table, Mask index, Mask chosen)
  {
#if defined(__AVX512F__)
    const __mmask16 lanes = _mm512_test_epi32_mask((__m512i)chosen, (__m512i)chosen);
    return (Mask)_mm512_mask_i32gather_epi32(
      _mm512_setzero_si512(), lanes, (__m512i)index, table, Size);
#else
    Mask value{};
    for (int k = 0; k < L::Count; ++k)
    {
      std::int32_t bits = 0;
      if (chosen[k] != 0)
      {
        __builtin_memcpy(&bits,
          static_cast<const char*>(table) + static_cast<std::int64_t>(index[k]) * Size,
          sizeof(bits));
      }
      value[k] = bits;
    }
    return value;
#endif
  }
  /// A table of up to PacketGrid::MostLevels + 1 numbers.
  TERRAIN_LANES_INLINE static Mask Look(const std::int32_t* table, Mask index)
  {
#if defined(__AVX512F__)
    return (Mask)_mm512_maskz_permutexvar_epi32(
      (__mmask16)-1, (__m512i)index, _mm512_loadu_si512(table));
#else
    Mask value{};
    for (int k = 0; k < L::Count; ++k)
    {
      value[k] = table[index[k]];
    }
    return value;
#endif
  }

  /// Mirrors rays so that they run north-east, relative to the cell where they start.
  TERRAIN_LANES_INLINE void Aim(const PacketRays& rays, int first)
  {
    // by way of memory: lanes set one by one are slow
    float origins[3][L::Count];
    float moves[3][L::Count];
    float ends[L::Count];
    float heights[L::Count];
    std::int32_t anchors[2][L::Count];
    for (int k = 0; k < L::Count; ++k)
    {
      const int ray = first + k;
      for (int axis = 0; axis < 2; ++axis)
      {
        const double at = rays.Origin[axis][ray];
        const double near = at > -1e9 ? (at < 1e9 ? at : 1e9) : -1e9;
        const auto whole = static_cast<std::int32_t>(near);
        const std::int32_t cell = whole - (static_cast<double>(whole) > near ? 1 : 0);
        anchors[axis][k] = cell;
        origins[axis][k] = static_cast<float>(at - cell);
        moves[axis][k] = static_cast<float>(rays.Direction[axis][ray]);
      }
      const double height = rays.Origin[2][ray] - this->Grid.Base;
      const double most = static_cast<double>(this->Grid.Highest);
      heights[k] = static_cast<float>(height > 0.0 ? (height < most ? height : most) : 0.0);
      origins[2][k] = static_cast<float>(height - static_cast<double>(heights[k]));
      moves[2][k] = static_cast<float>(rays.Direction[2][ray]);
      ends[k] = static_cast<float>(rays.End[ray]);
    }
    const Value move[3] = { L::Load(moves[0]), L::Load(moves[1]), L::Load(moves[2]) };
    this->MirrorX = move[0] < 0.0f;
    this->MirrorY = move[1] < 0.0f;
    this->AnchorX = (LoadWhole(anchors[0]) ^ this->MirrorX) - this->MirrorX;
    this->AnchorY = (LoadWhole(anchors[1]) ^ this->MirrorY) - this->MirrorY;
    this->OriginX = this->MirrorX ? -L::Load(origins[0]) : L::Load(origins[0]);
    this->OriginY = this->MirrorY ? -L::Load(origins[1]) : L::Load(origins[1]);
    this->OriginZ = L::Load(origins[2]);
    this->AnchorHeight = L::Load(heights);
    this->End = L::Load(ends);
    const Mask stillX = Magnitude(move[0]) < 1e-20f;
    const Mask stillY = Magnitude(move[1]) < 1e-20f;
    this->MoveX = stillX ? Value{} : Magnitude(move[0]);
    this->MoveY = stillY ? Value{} : Magnitude(move[1]);
    this->MoveZ = move[2];
    this->InverseX = stillX ? L::All(Still) : 1.0f / this->MoveX;
    this->InverseY = stillY ? L::All(Still) : 1.0f / this->MoveY;
    this->InverseZ = Magnitude(move[2]) < 1e-30f ? Value{} : 1.0f / move[2];
    this->LineX = stillX ? L::All(StillLine) : this->OriginX;
    this->LineY = stillY ? L::All(StillLine) : this->OriginY;
    this->FirstX = this->MirrorX & -this->Grid.CellsX;
    this->FirstY = this->MirrorY & -this->Grid.CellsY;
    this->LastX = this->FirstX + (this->Grid.CellsX - 1);
    this->LastY = this->FirstY + (this->Grid.CellsY - 1);
    this->Slack = 1e-6f * (this->Grid.Highest + Magnitude(this->OriginZ));
    this->HitDistance = L::All(__builtin_huge_valf());
    this->HitX = this->HitY = AllWhole(-1);
    this->FractionX = this->FractionY = this->SlopeX = this->SlopeY = Value{};
  }

  /// Clips rays to the box of the surface; those that miss it are not active.
  TERRAIN_LANES_INLINE void Enter()
  {
    const Value firstX = ToFloat(this->FirstX - this->AnchorX);
    const Value firstY = ToFloat(this->FirstY - this->AnchorY);
    const Value lastX = ToFloat(this->LastX + 1 - this->AnchorX);
    const Value lastY = ToFloat(this->LastY + 1 - this->AnchorY);
    const Mask stillX = this->MoveX == 0.0f;
    const Mask stillY = this->MoveY == 0.0f;
    Value begin = Most(Value{}, stillX ? Value{} : (firstX - this->OriginX) * this->InverseX);
    begin = Most(begin, stillY ? Value{} : (firstY - this->OriginY) * this->InverseY);
    Value end = Least(this->End, (lastX - this->LineX) * this->InverseX);
    end = Least(end, (lastY - this->LineY) * this->InverseY);
    const Mask level = this->InverseZ == 0.0f;
    const Value low = -this->AnchorHeight - this->OriginZ - this->Slack;
    const Value high = this->Grid.Highest - this->AnchorHeight - this->OriginZ + this->Slack;
    const Value atLow = low * this->InverseZ;
    const Value atHigh = high * this->InverseZ;
    begin = level ? begin : Most(begin, Least(atLow, atHigh));
    end = level ? end : Least(end, Most(atLow, atHigh));
    const Mask outside = (stillX & ((this->OriginX < firstX) | (this->OriginX > lastX))) |
      (stillY & ((this->OriginY < firstY) | (this->OriginY > lastY))) |
      (level & ((low > 0.0f) | (high < 0.0f)));
    this->Active = (begin <= end) & ~outside;
    this->End = end;
    this->Distance = this->Active ? begin : Value{};
    this->Height = this->OriginZ + this->MoveZ * this->Distance;
    this->CellX = this->CellAt(
      this->OriginX + this->MoveX * this->Distance, this->AnchorX, this->FirstX, this->LastX);
    this->CellY = this->CellAt(
      this->OriginY + this->MoveY * this->Distance, this->AnchorY, this->FirstY, this->LastY);
    this->Level = AllWhole(this->Grid.Levels < 2 ? this->Grid.Levels : 2);
    this->OnEast = this->OnNorth = Mask{};
  }
  TERRAIN_LANES_INLINE static Mask CellAt(Value position, Mask anchor, Mask first, Mask last)
  {
    return Least(Most(FloorToWhole(position) + anchor, first), last);
  }

  /// Where a ray leaves the node or cell that it stands on.
  struct Span
  {
    Mask LastX;
    Mask LastY;
    Mask CrossEast;
    Mask Ends;
    Value Distance;
    Value Height;
  };

  TERRAIN_LANES_INLINE Span Cross() const
  {
    Span span;
    const Mask within = (1 << this->Level) - 1;
    span.LastX = Least(this->CellX | within, this->LastX);
    span.LastY = Least(this->CellY | within, this->LastY);
    const Value leaveX = (ToFloat(span.LastX + 1 - this->AnchorX) - this->LineX) * this->InverseX;
    const Value leaveY = (ToFloat(span.LastY + 1 - this->AnchorY) - this->LineY) * this->InverseY;
    span.CrossEast = leaveX <= leaveY;
    const Value leave = Least(leaveX, leaveY);
    span.Ends = leave >= this->End;
    span.Distance = Least(Most(leave, this->Distance), this->End);
    span.Height = this->OriginZ + this->MoveZ * span.Distance;
    return span;
  }

  /// Lanes at nodes (inner) that may meet the surface in them, and from where.
  TERRAIN_LANES_INLINE Mask Descend(const Span& span, Mask inner, Value& next)
  {
    const Mask width = Look(this->Grid.LevelWidths, this->Level);
    const Mask height = Look(this->Grid.LevelHeights, this->Level);
    const Mask x = Least((this->CellX ^ this->MirrorX) >> this->Level, width - 1);
    const Mask y = Least((this->CellY ^ this->MirrorY) >> this->Level, height - 1);
    const Mask node =
      Gather<4>(this->Grid.Nodes, Look(this->Grid.LevelBegins, this->Level) + x + width * y, inner);
    const Value high =
      ToFloat(node & 0xffff) * this->Grid.NodeStep - this->AnchorHeight + this->Slack;
    const Value low =
      ToFloat((node >> 16) & 0xffff) * this->Grid.NodeStep - this->AnchorHeight - this->Slack;
    const Mask down =
      inner & (Least(this->Height, span.Height) <= high) & (Most(this->Height, span.Height) >= low);
    const Value bound = this->MoveZ < 0.0f ? high : low;
    const Value reach =
      Least(Most(this->Distance + (bound - this->Height) * this->InverseZ, this->Distance),
        span.Distance);
    next = down ? reach : next;
    return down;
  }

  /// The corners of a cell: south-west, south-east, north-west, north-east. Lanes whose cell has a
  /// surface.
  TERRAIN_LANES_INLINE Mask ReadCorners(Mask chosen, Value corners[4]) const
  {
    const Mask index =
      (this->CellX ^ this->MirrorX) + this->Grid.Stride * (this->CellY ^ this->MirrorY);
    if constexpr (FloatSamples)
    {
      const Mask samples[4] = { index, index + 1, index + this->Grid.Stride,
        index + this->Grid.Stride + 1 };
      Value lowest{};
      for (int corner = 0; corner < 4; ++corner)
      {
        const auto height = (Value)Gather<4>(this->Grid.Samples, samples[corner], chosen);
        lowest = Least(lowest, height);
        corners[corner] = height - this->AnchorHeight;
      }
      return lowest >= 0.0f;
    }
    else
    {
      const Mask south = Gather<2>(this->Grid.Samples, index, chosen);
      const Mask north = Gather<2>(this->Grid.Samples, index + this->Grid.Stride, chosen);
      corners[0] = ToFloat(south & 0xffff) - this->AnchorHeight;
      corners[1] = ToFloat((south >> 16) & 0xffff) - this->AnchorHeight;
      corners[2] = ToFloat(north & 0xffff) - this->AnchorHeight;
      corners[3] = ToFloat((north >> 16) & 0xffff) - this->AnchorHeight;
      return AllWhole(-1);
    }
  }

  /// A position within a cell; exactly 0 or 1 on a line that the ray has crossed, so that the cells
  /// that share it see the same height.
  TERRAIN_LANES_INLINE static Value Fraction(
    Value position, Mask cell, Mask anchor, Mask on, float side, Mask mirror)
  {
    Value fraction = Clamp01(position - ToFloat(cell - anchor));
    fraction = on ? L::All(side) : fraction;
    return mirror ? 1.0f - fraction : fraction;
  }
  TERRAIN_LANES_INLINE static Value Patch(const Value corners[4], Value x, Value y)
  {
    const Value south = corners[0] * (1.0f - x) + corners[1] * x;
    const Value north = corners[2] * (1.0f - x) + corners[3] * x;
    return south * (1.0f - y) + north * y;
  }

  /// First t in 0..1 with c + b t + a t^2 = 0, where c and e are the values at 0 and 1; -1 if there
  /// is none. As FirstRootBetween() in core/rays/QueryCells.h.
  TERRAIN_LANES_INLINE static Value FirstRoot(Value c, Value e, Value a)
  {
    const Value side = c < 0.0f ? L::All(-1.0f) : L::All(1.0f);
    c *= side;
    e *= side;
    a *= side;
    const Value b = e - c - a;
    const Value discriminant = b * b - 4.0f * a * c;
    const Mask dips = (b < 0.0f) & (b > -2.0f * a) & (discriminant >= 0.0f);
    const Value root = Root(Most(discriminant, Value{}));
    const Mask falls = b <= 0.0f;
    const Value t = (falls ? 2.0f * c : b + root) / (falls ? root - b : -2.0f * a);
    const Mask meets = (c == 0.0f) | (e <= 0.0f) | dips;
    return meets ? (c > 0.0f ? Clamp01(t) : Value{}) : L::All(-1.0f);
  }

  /// Meets rays with the patches of the cells they stand on; those that hit are not active then.
  TERRAIN_LANES_INLINE void Meet(const Span& span, Mask cells)
  {
    Value corners[4] = {};
    const Mask surface = this->ReadCorners(cells, corners);
    const Value beginX = Fraction(this->OriginX + this->MoveX * this->Distance, this->CellX,
      this->AnchorX, this->OnEast, 0.0f, this->MirrorX);
    const Value beginY = Fraction(this->OriginY + this->MoveY * this->Distance, this->CellY,
      this->AnchorY, this->OnNorth, 0.0f, this->MirrorY);
    const Value endX = Fraction(this->OriginX + this->MoveX * span.Distance, this->CellX,
      this->AnchorX, span.CrossEast & ~span.Ends, 1.0f, this->MirrorX);
    const Value endY = Fraction(this->OriginY + this->MoveY * span.Distance, this->CellY,
      this->AnchorY, ~span.CrossEast & ~span.Ends, 1.0f, this->MirrorY);
    const Value twist = (corners[0] - corners[1]) - (corners[2] - corners[3]);
    const Value t = FirstRoot(this->Height - Patch(corners, beginX, beginY),
      span.Height - Patch(corners, endX, endY), -twist * (endX - beginX) * (endY - beginY));
    const Mask found = cells & surface & (t >= 0.0f);
    if (L::Any(found))
    {
      const Value x = beginX + t * (endX - beginX);
      const Value y = beginY + t * (endY - beginY);
      const Value distance = this->Distance + t * (span.Distance - this->Distance);
      this->HitDistance = found ? distance : this->HitDistance;
      this->HitX = found ? this->CellX ^ this->MirrorX : this->HitX;
      this->HitY = found ? this->CellY ^ this->MirrorY : this->HitY;
      this->FractionX = found ? x : this->FractionX;
      this->FractionY = found ? y : this->FractionY;
      const Value south = corners[1] - corners[0];
      const Value west = corners[2] - corners[0];
      this->SlopeX = found ? south + y * ((corners[3] - corners[2]) - south) : this->SlopeX;
      this->SlopeY = found ? west + x * ((corners[3] - corners[1]) - west) : this->SlopeY;
    }
    this->Active &= ~(cells & (found | span.Ends));
  }

  TERRAIN_LANES_INLINE void Search()
  {
    std::int64_t left =
      std::int64_t{ 4 } * this->Grid.CellsX + std::int64_t{ 4 } * this->Grid.CellsY + 256;
    while (L::Any(this->Active) && left-- > 0)
    {
      const Span span = this->Cross();
      const Mask active = this->Active;
      const Mask inner = active & (this->Level > 0);
      const Mask cells = active & (this->Level == 0);
      Mask down{};
      Value next = span.Distance;
      if (L::Any(inner))
      {
        down = this->Descend(span, inner, next);
        this->Active &= ~(inner & span.Ends & ~down);
      }
      if (L::Any(cells))
      {
        this->Meet(span, cells);
      }
      this->Step(span, down, next);
    }
  }

  /// On: into the node below where a ray goes down, else over the line that it reaches, and up a
  /// level where that is a line of the parents, too.
  TERRAIN_LANES_INLINE void Step(const Span& span, Mask down, Value next)
  {
    const Mask moves = next > this->Distance;
    const Mask x =
      Least(Most(FloorToWhole(this->OriginX + this->MoveX * next) + this->AnchorX, this->CellX),
        span.LastX);
    const Mask y =
      Least(Most(FloorToWhole(this->OriginY + this->MoveY * next) + this->AnchorY, this->CellY),
        span.LastY);
    const Mask line = (span.CrossEast ? span.LastX : span.LastY) + 1;
    const Mask up = ((line >> this->Level) & 1) ^ 1;
    const Mask stays = down & ~moves;
    this->CellX = down ? (moves ? x : this->CellX) : (span.CrossEast ? line : x);
    this->CellY = down ? (moves ? y : this->CellY) : (span.CrossEast ? y : line);
    this->Level = down ? this->Level - 1 : Least(this->Level + up, AllWhole(this->Grid.Levels));
    this->OnEast = stays ? this->OnEast : (~down & span.CrossEast);
    this->OnNorth = stays ? this->OnNorth : (~down & ~span.CrossEast);
    this->Height = moves ? this->OriginZ + this->MoveZ * next : this->Height;
    this->Distance = next;
  }

  const PacketGrid& Grid;
  // mirrored
  Mask MirrorX;
  Mask MirrorY;
  Mask AnchorX;
  Mask AnchorY;
  Mask FirstX;
  Mask FirstY;
  Mask LastX;
  Mask LastY;
  Value OriginX;
  Value OriginY;
  Value OriginZ;
  Value AnchorHeight;
  Value MoveX;
  Value MoveY;
  Value MoveZ;
  Value InverseX;
  Value InverseY;
  Value InverseZ;
  Value LineX;
  Value LineY;
  Value Slack;
  Value End;
  // where they are
  Mask Active;
  Mask CellX;
  Mask CellY;
  Mask Level;
  Mask OnEast;
  Mask OnNorth;
  Value Distance;
  Value Height;
  // what they have met
  Value HitDistance;
  Mask HitX;
  Mask HitY;
  Value FractionX;
  Value FractionY;
  Value SlopeX;
  Value SlopeY;
};

inline void CastPacket(const PacketGrid& grid, const PacketRays& rays, PacketHits& hits)
{
  for (int first = 0; first < rays.Count; first += Lanes<float>::Count)
  {
    if (grid.FloatSamples)
    {
      PacketLanes<true>(grid).Cast(rays, first, hits);
    }
    else
    {
      PacketLanes<false>(grid).Cast(rays, first, hits);
    }
  }
}
} // namespace TERRAIN_LANES_KIND
} // namespace terrain

#endif
