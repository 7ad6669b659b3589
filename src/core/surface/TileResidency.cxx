// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/TileResidency.h"

#include <algorithm>
#include <utility>

namespace terrain
{
//------------------------------------------------------------------------------
TileResidency::TileResidency(std::shared_ptr<TilePool> pool, std::size_t slots, std::size_t uploads)
  : Pool(std::move(pool))
  , Pages(this->Pool->GetSource().GetLayout())
  , NumberOfSlots(std::max<std::size_t>(slots, 1))
  , MostUploads(std::max<std::size_t>(uploads, 1))
{
  this->Clear();
}

//------------------------------------------------------------------------------
void TileResidency::Clear()
{
  this->Residents.clear();
  this->Free.clear();
  for (std::size_t slot = this->NumberOfSlots; slot > 0; --slot)
  {
    this->Free.push_back(slot - 1);
  }
  this->Pages.Clear();
}

//------------------------------------------------------------------------------
bool TileResidency::FindSlot(std::size_t& slot)
{
  if (!this->Free.empty())
  {
    slot = this->Free.back();
    this->Free.pop_back();
    return true;
  }
  const auto oldest = std::min_element(this->Residents.begin(), this->Residents.end(),
    [](const auto& a, const auto& b) { return a.second.Used < b.second.Used; });
  if (oldest == this->Residents.end() || oldest->second.Used == this->Frame)
  {
    return false;
  }
  slot = oldest->second.Slot;
  this->Residents.erase(oldest);
  return true;
}

//------------------------------------------------------------------------------
std::vector<TileUpload> TileResidency::Update(const TileView& view)
{
  ++this->Frame;
  this->Selection = SelectTiles(this->Pool->GetSource(), view, this->NumberOfSlots,
    [this](const TileKey& key) { return this->Pool->FindRelief(key); });
  std::vector<TileKey> missing;
  for (const TileWish& wish : this->Selection.Tiles)
  {
    const auto resident = this->Residents.find(wish.Key);
    if (resident != this->Residents.end())
    {
      resident->second.Used = this->Frame;
    }
    else if (!this->Pool->HasFailed(wish.Key))
    {
      missing.push_back(wish.Key);
    }
  }
  this->Pool->Want(missing);
  std::vector<TileUpload> uploads;
  this->Pages.Clear();
  std::size_t waiting = 0;
  for (const TileWish& wish : this->Selection.Tiles)
  {
    auto resident = this->Residents.find(wish.Key);
    if (resident == this->Residents.end() && !this->Pool->HasFailed(wish.Key))
    {
      ++waiting;
      TileUpload upload{ wish.Key, 0, nullptr };
      if (uploads.size() < this->MostUploads)
      {
        upload.Content = this->Pool->Find(wish.Key);
      }
      if (upload.Content && this->FindSlot(upload.Slot))
      {
        --waiting;
        resident = this->Residents.emplace(wish.Key, Resident{ upload.Slot, this->Frame }).first;
        uploads.push_back(std::move(upload));
      }
    }
    const bool hasParent =
      wish.Key.Level == this->Pages.Top() || this->Pages.IsShown(wish.Key.Parent());
    if (resident != this->Residents.end() && hasParent)
    {
      this->Pages.Set(wish.Key, static_cast<std::uint32_t>(resident->second.Slot + 1));
    }
  }
  this->Complete = waiting == 0 && this->Selection.IsFinal;
  return uploads;
}

//------------------------------------------------------------------------------
void TileResidency::Finish(const TileView& view, const std::function<void(const TileUpload&)>& take)
{
  do
  {
    this->Pool->Wait();
    for (const TileUpload& upload : this->Update(view))
    {
      take(upload);
    }
  } while (!this->Complete);
}
}
