// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fonts.h"

#include "Messages.h"

#include "vtkFreeTypeTools.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTextProperty.h"

#include <filesystem>
#include <set>
#include <system_error>
#include <vector>

namespace
{
/// Where Debian, Fedora, Arch and macOS have them, the nearest to VTK's own in looks first.
constexpr const char* kSystemFonts[] = { "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
  "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
  "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
  "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
  "/usr/share/fonts/google-noto-cjk/NotoSansCJK-Regular.ttc",
  "/usr/share/fonts/noto-cjk/NotoSansCJK-Regular.ttc",
  "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf", "/Library/Fonts/Arial Unicode.ttf",
  "/System/Library/Fonts/Supplemental/Arial Unicode.ttf" };

/// Asks VTK's fonts for letters, which only its own classes may.
class GlyphFinder : public vtkFreeTypeTools
{
public:
  static GlyphFinder* New();
  vtkTypeMacro(GlyphFinder, vtkFreeTypeTools)

  bool Has(vtkTextProperty* property, unsigned int letter)
  {
    FT_UInt index = 0;
    return this->GetGlyphIndex(property, letter, &index) && index != 0;
  }
};

vtkStandardNewMacro(GlyphFinder);

/// Bytes of the letter of UTF-8 that begins with one.
std::size_t LengthOfLetter(unsigned char first)
{
  return first < 0x80U ? 1 : first < 0xE0U ? 2 : first < 0xF0U ? 3 : 4;
}

/// The number in Unicode of a letter of UTF-8.
unsigned int NumberOfLetter(const std::string& letter)
{
  constexpr unsigned char kFirstBits[] = { 0, 0x7F, 0x1F, 0x0F, 0x07 };
  unsigned int number = static_cast<unsigned char>(letter[0]) & kFirstBits[letter.size()];
  for (std::size_t k = 1; k < letter.size(); ++k)
  {
    number = number << 6U | (static_cast<unsigned char>(letter[k]) & 0x3FU);
  }
  return number;
}

/// Different letters of a text, without spaces and control characters.
std::set<std::string> LettersOf(const std::string& text)
{
  std::set<std::string> letters;
  for (std::size_t k = 0; k < text.size(); k += LengthOfLetter(text[k]))
  {
    if (static_cast<unsigned char>(text[k]) > ' ')
    {
      letters.insert(text.substr(k, LengthOfLetter(text[k])));
    }
  }
  return letters;
}

/// Those of some letters that the font of a property lacks, in one text.
std::vector<std::string> MissingOf(
  GlyphFinder* finder, vtkTextProperty* property, const std::set<std::string>& letters)
{
  std::vector<std::string> missing;
  for (const std::string& letter : letters)
  {
    if (!finder->Has(property, NumberOfLetter(letter)))
    {
      missing.push_back(letter);
    }
  }
  return missing;
}
}

//------------------------------------------------------------------------------
void ChooseFont(vtkTextProperty* property, const std::string& text)
{
  const std::set<std::string> letters = LettersOf(text);
  if (letters.empty() || letters.rbegin()->size() == 1) // ASCII
  {
    return;
  }
  const vtkNew<GlyphFinder> finder;
  const vtkNew<vtkTextProperty> other;
  std::vector<std::string> missing = MissingOf(finder, property, letters);
  for (const char* file : kSystemFonts)
  {
    std::error_code error;
    if (missing.empty() || !std::filesystem::is_regular_file(file, error))
    {
      continue;
    }
    other->SetFontFamily(VTK_FONT_FILE);
    other->SetFontFile(file);
    const std::vector<std::string> still = MissingOf(finder, other, letters);
    if (still.size() < missing.size())
    {
      missing = still;
      property->SetFontFamily(VTK_FONT_FILE);
      property->SetFontFile(file);
    }
  }
  if (!missing.empty())
  {
    std::string names;
    for (const std::string& letter : missing)
    {
      names.append(names.empty() ? "" : " ").append(letter);
    }
    Warn("no font here has " + names + " with the rest of '" + text +
      "': install one that has, as DejaVu Sans or Noto Sans CJK");
  }
}
