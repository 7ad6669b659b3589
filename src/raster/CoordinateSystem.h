// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A coordinate reference system (CRS), read and transformed by GDAL/OGR's C API over PROJ. Private
 * to the module.
 *
 * x is always east and y north, whatever the order and sense of axes in the definition. Places
 * are longitude, latitude in degrees on WGS84. Heights are not touched; what a compound system says
 * about them is only reported.
 *
 * Transformations are not thread safe in OGR: each call borrows one of its own from a pool, so that
 * the transforming functions may be called from any number of threads at once.
 */
#ifndef vtkTerrain_raster_CoordinateSystem_h
#define vtkTerrain_raster_CoordinateSystem_h

#include <cstdint>
#include <memory>
#include <string>

namespace terrain
{
class CoordinateSystem
{
public:
  enum class Kind
  {
    /// No definition was given.
    None,
    /// Longitude and latitude.
    Geographic,
    /// A map projection.
    Projected,
    /// An engineering system, tied to no place on earth.
    Engineering,
    /// Of a planet or moon.
    OtherWorld
  };

  CoordinateSystem();
  ~CoordinateSystem();
  CoordinateSystem(const CoordinateSystem&) = delete;
  void operator=(const CoordinateSystem&) = delete;

  /// Reads WKT, "EPSG:n" or a PROJ string. Returns one sentence if it cannot be used, else nothing;
  /// an empty definition and an engineering system are no errors.
  std::string Read(const std::string& definition);

  Kind GetKind() const
  {
    return this->TheKind;
  }
  /// True for Geographic and Projected.
  bool IsOnEarth() const
  {
    return this->TheKind == Kind::Geographic || this->TheKind == Kind::Projected;
  }
  /// True if longitude and latitude can be had: on the earth, where they are those of WGS84, and on
  /// other worlds, where they are those of the system's own ellipsoid.
  bool HasPlaces() const;
  /// True if x and y are angles, on the earth or elsewhere.
  bool IsInDegrees() const
  {
    return this->TheKind == Kind::Geographic ||
      (this->TheKind == Kind::OtherWorld && this->Degrees > 0.0);
  }
  /// Empty if x and y are longitude and latitude on a body, else one sentence that says why not.
  std::string WhyNotLongitudeLatitude() const;
  ///@{
  /// Semi-axes of the ellipsoid in metres; WGS84's where no definition was given.
  double GetSemiMajor() const
  {
    return this->SemiMajor;
  }
  double GetSemiMinor() const
  {
    return this->SemiMinor;
  }
  ///@}
  const std::string& GetName() const
  {
    return this->Name;
  }
  /// Metres per unit of x and y (Projected, Engineering, OtherWorld), 1 otherwise.
  double GetMetres() const
  {
    return this->Metres;
  }
  /// Degrees per unit of x and y where those are angles.
  double GetDegrees() const
  {
    return this->Degrees;
  }
  /// What a compound or three-dimensional system says of heights: empty if it says nothing.
  const std::string& GetVerticalName() const
  {
    return this->VerticalName;
  }
  /// Metres per unit of height, 0 if the system does not say.
  double GetVerticalMetres() const
  {
    return this->VerticalMetres;
  }
  bool HasEllipsoidalHeights() const
  {
    return this->EllipsoidalHeights;
  }

  /// Replaces x and y of count points (stride doubles apart) by longitude and latitude; NaN where
  /// there is none, as for numbers above 1e12. False if no transformation exists.
  bool ToPlaces(double* points, std::int64_t count, int stride = 3) const;
  /// The inverse. In geographic systems x is the multiple of a turn that is nearest to nearX.
  bool FromPlaces(double* points, std::int64_t count, double nearX = 0.0, int stride = 3) const;

  /// WKT of any definition that Read takes; empty if it is not understood.
  static std::string ToWkt(const std::string& definition);

private:
  class Pool;
  ///@{
  /// Parts of Read() on OGR's references (OGRSpatialReferenceH): of what a definition says of
  /// heights; how the flat rest, of another world or of the earth, comes to places. Those that
  /// return a text say why not.
  void ReadVertical(void* whole);
  std::string ReadFlat(void* flat);
  void JoinOtherWorld(void* flat, bool projected);
  std::string JoinEarth(void* flat, bool projected);
  ///@}
  bool Transform(double* points, std::int64_t count, int stride, bool forward) const;

  Kind TheKind = Kind::None;
  std::string Name;
  double Metres = 1.0;
  double Degrees = 1.0;
  double SemiMajor = 6378137.0;
  double SemiMinor = 6356752.314245179;
  bool CountsWest = false;
  std::string VerticalName;
  double VerticalMetres = 0.0;
  bool EllipsoidalHeights = false;
  /// Degrees on WGS84 from Greenwich, or on the body of another world: nothing to transform.
  bool IsPlaces = false;
  std::unique_ptr<Pool> Transformations;
};
}
#endif
