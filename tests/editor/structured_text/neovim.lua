-- SPDX-License-Identifier: MIT
-- Open a text, wait for its findings, ask what a name is, correct it, format, write.
-- The command of the server stands in the variable NCTAKT_LSP, words separated by blanks.

local command = vim.split(vim.env.NCTAKT_LSP, " ")
local buffer = vim.api.nvim_get_current_buf()
local client_id = vim.lsp.start_client({
  name = "nctakt",
  cmd = command,
  root_dir = vim.fn.getcwd(),
  get_language_id = function() return "nctakt-st" end,
})
vim.lsp.buf_attach_client(buffer, client_id)

local function findings()
  return vim.diagnostic.get(buffer)
end

assert(vim.wait(30000, function() return #findings() > 0 end, 20), "no findings")
for _, item in ipairs(findings()) do
  io.stdout:write(("finding %d %d %s\n"):format(item.lnum, item.col, item.message:match("[^\n]*")))
end

local client = vim.lsp.get_client_by_id(client_id)
local document = vim.lsp.util.make_text_document_params(buffer)
local answer = client.request_sync("textDocument/hover", {
  textDocument = document,
  position = { line = 4, character = 0 },
}, 30000, buffer)
io.stdout:write("hover " .. answer.result.contents.value:match("\n([^\n]*)") .. "\n")

vim.api.nvim_buf_set_text(buffer, 4, 5, 4, 6, { "n" })
assert(vim.wait(30000, function() return #findings() == 0 end, 20), "findings are left")
answer = client.request_sync("textDocument/formatting", {
  textDocument = document,
  options = { tabSize = 4, insertSpaces = true },
}, 30000, buffer)
vim.lsp.util.apply_text_edits(answer.result, buffer, client.offset_encoding)
vim.cmd("write")
client.stop()
vim.wait(5000, function() return client.is_stopped() end, 20)
vim.cmd("qall!")
