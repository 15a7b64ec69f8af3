// SPDX-License-Identifier: MIT
// Rows of findings, messages and events: kind, line, text, remedy, file of the PLC, file and line
// elsewhere, signal. A click or Enter emits the signal, or else the line with the file of the PLC.
export default {
  template: `
    <div :aria-live="live">
      <div v-for="(row, index) in rows" :key="index" :class="['nc-finding', row[0]]" v-bind="row[1] || row[6] ? act : {}"
        :aria-current="row[0].endsWith(' current') || null" @click="choose(row)" @keydown.enter="choose(row)">
        <div class="nc-rows"><div>{{ row[2] }}</div><div class="nc-soft">{{ row[5] || (row[1] ? word + " " + row[1] : "") }}</div></div>
        <div v-if="row[3]" class="nc-soft">{{ row[3] }}</div>
      </div>
      <div v-if="!rows.length" class="nc-soft">{{ empty }}</div>
    </div>`,
  props: { rows: Array, word: String, empty: String, live: String },
  methods: {
    choose(row) {
      if (row[6]) this.$emit("signal", row[6]);
      else this.$emit("line", [row[1], row[4]]);
    },
  },
  data: () => ({ act: { role: "button", tabindex: 0 } }),
};
