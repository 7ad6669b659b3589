// SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include "Failure.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <iostream>
#include <mutex>
#include <set>
#include <string>

namespace
{
const char* Program = "";

/// The text of a message in one line: without "ERROR: In file, line n", without the object.
std::string Sentence(const std::string& message)
{
  std::string text = message;
  const std::size_t object = text.find("): ");
  if (object != std::string::npos)
  {
    text = text.substr(object + 3);
  }
  std::string line;
  for (const char c : text)
  {
    const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!space)
    {
      line += c;
    }
    else if (!line.empty() && line.back() != ' ')
    {
      line += ' ';
    }
  }
  while (!line.empty() && line.back() == ' ')
  {
    line.pop_back();
  }
  return line;
}

class MessageCatcher : public vtkOutputWindow
{
public:
  static MessageCatcher* New();
  vtkTypeMacro(MessageCatcher, vtkOutputWindow)

  void DisplayErrorText(const char* text) override
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->FirstError.empty())
    {
      this->FirstError = Sentence(text);
    }
  }

  void DisplayWarningText(const char* text) override
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    Warn(Sentence(text));
  }

  /// The text of the first error since the last call, empty if there was none.
  std::string TakeFirstError()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    std::string error;
    error.swap(this->FirstError);
    return error;
  }

private:
  std::mutex Mutex;
  std::string FirstError;
};

vtkStandardNewMacro(MessageCatcher);
}

//------------------------------------------------------------------------------
void CatchMessages(const char* program)
{
  Program = program;
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  const vtkNew<MessageCatcher> catcher;
  vtkOutputWindow::SetInstance(catcher);
}

//------------------------------------------------------------------------------
void Warn(const std::string& text)
{
  static std::mutex mutex;
  static std::set<std::string> told;
  const std::lock_guard<std::mutex> lock(mutex);
  if (told.insert(text).second)
  {
    std::cerr << Program << ": warning: " << text << '\n';
  }
}

//------------------------------------------------------------------------------
void Tell(const std::string& text)
{
  std::cerr << Program << ": " << text << '\n';
}

//------------------------------------------------------------------------------
void ThrowOnError(const std::string& what)
{
  MessageCatcher* catcher = MessageCatcher::SafeDownCast(vtkOutputWindow::GetInstance());
  const std::string error = catcher ? catcher->TakeFirstError() : std::string();
  if (error.empty())
  {
    return;
  }
  if (error.find(what) != std::string::npos)
  {
    throw Failure(error);
  }
  throw Failure(what, error);
}
