// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Which tiles lie in the slots of the graphics card, frame by frame.
 */
#ifndef terrain_TileResidency_h
#define terrain_TileResidency_h

#include "core/surface/TilePool.h"
#include "core/surface/TileSlots.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace terrain
{
/// A tile that goes to a slot.
struct TileUpload
{
  TileKey Key;
  std::size_t Slot = 0;
  std::shared_ptr<const Tile> Content;
};

/// Shows the tiles that a view needs as they come; those only, so that the picture of a view does
/// not depend on the views before it.
class TileResidency
{
public:
  /// Slots of the card, >= 1, and the most tiles sent there in a frame, >= 1.
  TileResidency(std::shared_ptr<TilePool> pool, std::size_t slots, std::size_t uploads);

  /// Brings the pages up to date for a view. Returns the tiles to be sent before it is drawn.
  std::vector<TileUpload> Update(const TileView& view);

  const TilePages& GetPages() const
  {
    return this->Pages;
  }
  /// True if the view has all the tiles that it needs, or that can be read.
  bool IsComplete() const
  {
    return this->Complete;
  }
  /// False if the view needs more tiles than there are slots.
  bool Fits() const
  {
    return this->Selection.Fits;
  }
  std::size_t GetNumberOfTiles() const
  {
    return this->Selection.Tiles.size();
  }
  /// Forgets what is in the slots: the card has lost them.
  void Clear();
  /// Updates until the view is complete; sends to `take`.
  void Finish(const TileView& view, const std::function<void(const TileUpload&)>& take);

private:
  struct Resident
  {
    std::size_t Slot = 0;
    std::uint64_t Used = 0;
  };

  /// A slot that is free, or whose tile this frame does not use; false if there is none.
  bool FindSlot(std::size_t& slot);

  std::shared_ptr<TilePool> Pool;
  TilePages Pages;
  TileSelection Selection;
  std::map<TileKey, Resident> Residents;
  std::vector<std::size_t> Free;
  std::size_t NumberOfSlots;
  std::size_t MostUploads;
  std::uint64_t Frame = 0;
  bool Complete = false;
};
}

#endif
