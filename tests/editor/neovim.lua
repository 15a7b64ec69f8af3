-- SPDX-License-Identifier: MIT
-- Open the program, wait for its findings, apply the preferred code action, format, write.
-- The command of the server stands in the variable NCTAKT_LSP, words separated by blanks.

local command = vim.split(vim.env.NCTAKT_LSP, " ")
local buffer = vim.api.nvim_get_current_buf()
local client_id = vim.lsp.start_client({
  name = "nctakt",
  cmd = command,
  root_dir = vim.fn.getcwd(),
  get_language_id = function() return "nctakt" end,
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
local params = {
  textDocument = vim.lsp.util.make_text_document_params(buffer),
  range = { start = { line = 0, character = 0 }, ["end"] = { line = 99, character = 0 } },
  context = { diagnostics = {} },
}
local answer = client.request_sync("textDocument/codeAction", params, 30000, buffer)
for _, action in ipairs(answer.result) do
  if action.isPreferred then
    io.stdout:write("action " .. action.title .. "\n")
    vim.lsp.util.apply_workspace_edit(action.edit, client.offset_encoding)
    break
  end
end
assert(vim.wait(30000, function() return #findings() == 0 end, 20), "findings are left")

answer = client.request_sync("textDocument/formatting", {
  textDocument = params.textDocument,
  options = { tabSize = 2, insertSpaces = true },
}, 30000, buffer)
vim.lsp.util.apply_text_edits(answer.result, buffer, client.offset_encoding)
vim.cmd("write")
client.stop()
vim.wait(5000, function() return client.is_stopped() end, 20)
vim.cmd("qall!")
