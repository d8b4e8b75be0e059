# Balcony: rendering through extended cameras.
# SPDX-License-Identifier: Apache-2.0
"""The lines of docs/editors.md for Neovim: what its user gets from balcony lsp."""

import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import guide

if shutil.which("nvim") is None:
    guide.skip("Neovim is not installed")

TEXT = """// Half of a room.
camera wide(fov = 180deg) {
    map u = fov/2 .. -fov/2, v = square
    eye sphrere(1)
}
"""

# What a user does, and what is then to be seen.
STEPS = """
local seen = {}
local function wait(condition)
  assert(vim.wait(20000, condition, 20), "nothing has come")
end
local function place(line, column)
  local made = vim.lsp.util.make_position_params()
  made.position = { line = line, character = column }
  return made
end
local function ask(method, params)
  for _, answer in pairs(assert(vim.lsp.buf_request_sync(0, method, params, 20000))) do
    assert(not answer.error, vim.inspect(answer.error))
    return answer.result
  end
end
local function finish(ok, failure)
  seen.failure = failure
  vim.fn.writefile({ vim.json.encode(seen) }, "seen.json")
  vim.cmd("qall!")
end
local function steps()
  wait(function() return #vim.diagnostic.get(0) > 0 end)
  local said = vim.diagnostic.get(0)[1]
  seen.diagnostic = { said.lnum, said.col, said.message }
  local range = { start = { line = 3, character = 8 }, ["end"] = { line = 3, character = 8 } }
  local fix = ask("textDocument/codeAction", {
    textDocument = vim.lsp.util.make_text_document_params(), range = range,
    context = { diagnostics = {} } })[1]
  seen.fix = fix.title
  vim.lsp.util.apply_workspace_edit(fix.edit, "utf-16")
  seen.fixed = vim.api.nvim_buf_get_lines(0, 3, 4, true)[1]
  wait(function() return #vim.diagnostic.get(0) == 0 end)

  local told = ask("textDocument/hover", place(3, 9))
  seen.hover = vim.lsp.util.convert_input_to_markdown_lines(told.contents)[2]

  vim.api.nvim_win_set_cursor(0, { 4, 0 })
  vim.api.nvim_feedkeys(vim.api.nvim_replace_termcodes("olook <C-x><C-o>", true, false, true), "n", false)
  -- The menu comes when these functions do not run.
  local tries = 0
  local function end_with_menu()
    local items = vim.fn.complete_info({ "items" }).items or {}
    tries = tries + 1
    if #items == 0 and tries < 300 then
      vim.defer_fn(end_with_menu, 100)
      return
    end
    finish(pcall(function()
      seen.menu = assert(items[1], "no menu has come").word
      vim.cmd("stopinsert")
      vim.api.nvim_buf_set_lines(0, 4, 5, true, {})
      vim.api.nvim_win_set_cursor(0, { 2, 13 })
      local made = ask("textDocument/rename", vim.tbl_extend("force", place(1, 13), { newName = "angle" }))
      vim.lsp.util.apply_workspace_edit(made, "utf-16")
      vim.lsp.util.apply_text_edits(ask("textDocument/formatting", {
        textDocument = vim.lsp.util.make_text_document_params(), options = {} }), 0, "utf-16")
      seen.text = table.concat(vim.api.nvim_buf_get_lines(0, 0, -1, true), "\\n")
    end))
  end
  end_with_menu()
end
vim.defer_fn(function()
  local ok, failure = pcall(steps)
  if not ok then
    finish(ok, failure)
  end
end, 10)
"""


class Neovim(unittest.TestCase):
    def test_what_its_user_sees(self):
        folder = Path(tempfile.mkdtemp(prefix="balcony-editors-"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        page = guide.page_text("editors.md")
        (folder / "init.lua").write_text(re.search(r"```lua\n(.*?)```", page, re.S)[1])
        (folder / "steps.lua").write_text(STEPS)
        (folder / "my.cam").write_text(TEXT)
        words = {**os.environ, "PATH": f"{guide.BALCONY.parent}:{os.environ['PATH']}",
                 "HOME": str(folder), "XDG_STATE_HOME": str(folder)}
        subprocess.run(["nvim", "--headless", "-n", "-u", "init.lua", "my.cam",
                        "-c", "luafile steps.lua"],
                       cwd=folder, env=words, timeout=100, check=True, capture_output=True)
        seen = json.loads((folder / "seen.json").read_text())
        print(json.dumps(seen, indent=4))
        self.assertNotIn("failure", seen)
        self.assertEqual(seen["diagnostic"], [3, 8, "there is no object generator named 'sphrere'\n"
                                                    "did you mean 'sphere'?"])
        self.assertEqual(seen["fix"], "write 'sphere'")
        self.assertEqual(seen["fixed"], "    eye sphere(1)")
        self.assertEqual(seen["hover"], "sphere(radius, by)")
        self.assertTrue(seen["menu"].startswith("normal"), seen["menu"])
        self.assertEqual(seen["text"], TEXT.replace("fov", "angle").replace("sphrere", "sphere")
                         .rstrip("\n"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
