// SPDX-License-Identifier: MIT
// The lines of a file of the PLC: numbers, colours, the current statement, values beside them.
// Only those in view are elements; all have the same height.
const HEIGHT = 19, AROUND = 12;
const MOVES = { ArrowDown: () => 1, ArrowUp: () => -1, PageDown: (page) => page, PageUp: (page) => -page,
  Home: () => -Infinity, End: () => Infinity };

export default {
  template: `<div class="nc-plc-holder">
    <div class="nc-plc-lines" role="listbox" tabindex="0" :aria-label="name" ref="scroller" data-testid="plc-lines"
      :aria-activedescendant="isShown(cursor) ? idOf(cursor) : null" @scroll="scroll" @keydown="move"
      @pointermove="point" @pointerleave="leave">
      <div role="presentation" :style="{ height: rows.length * height + 'px', position: 'relative' }">
        <div v-for="index in shown" :key="index" role="option" :id="idOf(index)" :aria-selected="index === cursor"
          :aria-setsize="rows.length" :aria-posinset="index + 1" :style="{ top: index * height + 'px' }"
          :class="['nc-plc-line', rows[index][0] ? '' : 'nc-plc-heading', index === cursor ? 'nc-plc-cursor' : '',
            ...(marks[index] || [])]" @click="put(index)"
          ><span class="nc-plc-number" @click.stop="stop(index)">{{ rows[index][0] || "" }}</span
          ><span class="nc-plc-text"><span v-for="(part, at) in rows[index][1]" :key="at" :class="part[1]">{{ part[0]
          }}</span></span><span v-if="beside[index]" class="nc-plc-value">{{ beside[index] }}</span></div>
      </div>
    </div>
    <div class="nc-plc-tip cm-tooltip" v-show="tip" :style="tip ? tipPlace : {}" data-testid="plc-tip"><div
      :class="tip ? 'nc-tip' : ''" ref="tip" role="status"></div></div>
  </div>`,
  props: { rows: Array, name: String, marks: Object, beside: Object },
  data: () => ({ first: 0, last: 0, cursor: 0, height: HEIGHT, view: "", tip: null }),
  computed: {
    tipPlace() {
      const { index, x } = this.tip, { scrollTop, clientHeight } = this.$refs.scroller;
      const top = index * HEIGHT - scrollTop, isLow = top > clientHeight / 2;
      return { left: `${Math.max(0, x)}px`, top: `${isLow ? top : top + HEIGHT}px`,
        transform: isLow ? "translateY(-100%)" : "none" };
    },
    shown() {
      const first = Math.max(0, this.first - AROUND), end = Math.min(this.rows.length, this.last + AROUND);
      return Array.from({ length: Math.max(0, end - first) }, (_, index) => first + index);
    },
  },
  mounted() {
    this.observer = new ResizeObserver(() => this.look());
    this.observer.observe(this.$refs.scroller);
    this.look();
  },
  unmounted() { this.observer.disconnect(); },
  watch: { rows() { this.$nextTick(() => this.look()); } },
  methods: {
    idOf(index) { return `nc-plc-${this.$.uid}-${index}`; },
    isShown(index) { return this.shown.includes(index); },
    scroll() {
      this.leave();
      this.look();
    },
    look() {
      const { scrollTop, clientHeight } = this.$refs.scroller;
      this.first = Math.floor(scrollTop / HEIGHT);
      this.last = Math.ceil((scrollTop + clientHeight) / HEIGHT);
      const view = `${this.first} ${this.last} ${this.rows.length}`;
      if (view === this.view || !clientHeight) return;
      this.view = view;
      this.$emit("view", [this.first, this.last]);
    },
    // When the pointer rests on a word, the server explains it; F1 explains all words of the cursor's row.
    point(event) {
      clearTimeout(this.rest);
      const { clientX, clientY } = event, text = event.target.closest(".nc-plc-text");
      if (this.pointed && text !== this.pointed) this.leave();
      if (!text) return;
      this.rest = setTimeout(() => {
        const at = document.caretPositionFromPoint(clientX, clientY);
        if (!at || !text.contains(at.offsetNode)) return;
        const range = document.createRange();
        range.setStart(text, 0);
        range.setEnd(at.offsetNode, at.offset);
        const box = this.$refs.scroller.getBoundingClientRect();
        this.pointed = text;
        this.ask(this.shown[[...text.parentNode.parentNode.children].indexOf(text.parentNode)],
          range.toString().length, Math.min(clientX - box.left - 12, box.width / 2));
      }, 300);
    },
    leave() {
      clearTimeout(this.rest);
      this.pointed = null;
      this.asked = null;
      this.tip = null;
    },
    explain() { this.ask(this.cursor, -1, 60); },
    ask(index, column, x) {
      this.asked = { index, x, number: (this.asked?.number ?? 0) + 1 };
      this.$emit("explain", [index, column]);
    },
    showTip(index, html) {
      if (!this.asked || this.asked.index !== index) return;
      this.tip = html ? this.asked : null;
      this.$refs.tip.setHTML(html);
    },
    put(index) {
      if (index !== this.cursor) this.leave();
      this.cursor = index;
      this.$emit("cursor", index);
    },
    stop(index) {
      this.put(index);
      this.$emit("stop", index);
    },
    move(event) {
      if (event.key === "Escape") this.leave();
      if (event.key === "Enter") this.$emit("enter");
      if (event.ctrlKey || event.metaKey || event.altKey || !(event.key in MOVES)) return;
      event.preventDefault();
      const page = Math.max(1, Math.floor(this.$refs.scroller.clientHeight / HEIGHT) - 1);
      this.show(Math.max(0, Math.min(this.rows.length - 1, this.cursor + MOVES[event.key](page))));
    },
    // Moves the cursor to a row and scrolls it into view.
    async show(index) {
      await this.$nextTick(); // other rows may have arrived at the same time
      this.put(index);
      const scroller = this.$refs.scroller, top = index * HEIGHT;
      const isAbove = top < scroller.scrollTop, isBelow = top + HEIGHT > scroller.scrollTop + scroller.clientHeight;
      if (isAbove || isBelow) scroller.scrollTop = Math.max(0, top - scroller.clientHeight / 2);
    },
    focus() { this.$refs.scroller.focus(); },
  },
};
