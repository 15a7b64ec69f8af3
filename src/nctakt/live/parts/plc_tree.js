// SPDX-License-Identifier: MIT
// The variables in a line of the PLC as a tree that unfolds structures, arrays and pointers.
export default {
  template: `
    <div v-if="rows.length" class="nc-plc-tree" role="tree" tabindex="0" :aria-label="name" ref="tree" data-testid="plc-tree"
      :aria-activedescendant="idOf(cursor)" @keydown="move">
      <div v-for="(row, index) in rows" :key="row.path" role="treeitem" :id="idOf(index)" :aria-level="row.depth + 1"
        :aria-selected="index === cursor" :aria-expanded="row.count ? row.isOpen : null" :title="row.type"
        :class="['nc-plc-branch', index === cursor ? 'nc-plc-cursor' : '']"
        :style="{ paddingLeft: 6 + 14 * row.depth + 'px' }" @click="press(index)"
        ><span class="nc-plc-fold" aria-hidden="true">{{ row.count ? (row.isOpen ? "▾" : "▸") : "" }}</span
        ><span>{{ row.name }}</span><span class="nc-soft">{{ row.text ? " = " + row.text : "" }}</span></div>
    </div>`,
  props: { rows: Array, name: String },
  data: () => ({ cursor: 0 }),
  watch: { rows(rows) { this.cursor = Math.max(0, Math.min(this.cursor, rows.length - 1)); } },
  methods: {
    idOf(index) { return `nc-plc-tree-${this.$.uid}-${index}`; },
    press(index) {
      this.cursor = index;
      if (this.rows[index].count) this.$emit("fold", this.rows[index].path);
    },
    parentOf(index) {
      let above = index;
      while (above > 0 && this.rows[above].depth >= this.rows[index].depth) above -= 1;
      return this.rows[above].depth < this.rows[index].depth ? above : index;
    },
    focus() { this.$refs.tree?.focus(); },
    move(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const row = this.rows[this.cursor], last = this.rows.length - 1;
      const isFolded = row.count && !row.isOpen;
      const goals = {
        ArrowDown: () => this.cursor + 1, ArrowUp: () => this.cursor - 1, Home: () => 0, End: () => last,
        ArrowRight: () => (row.count && row.isOpen ? this.cursor + 1 : this.cursor),
        ArrowLeft: () => (row.count && row.isOpen ? this.cursor : this.parentOf(this.cursor)),
      };
      if (!(event.key in goals)) return;
      event.preventDefault();
      if ((event.key === "ArrowRight" && isFolded) || (event.key === "ArrowLeft" && row.isOpen)) this.$emit("fold", row.path);
      this.cursor = Math.max(0, Math.min(last, goals[event.key]()));
      this.$nextTick(() => document.getElementById(this.idOf(this.cursor))?.scrollIntoView({ block: "nearest" }));
    },
  },
};
