// SPDX-License-Identifier: MIT
// Tables of times: for each channel its title and tables; a table has heads, rows and the lines of
// its first rows, 0 for lines outside the shown program. A click or Enter on a row emits its line.
export default {
  template: `
    <div>
      <div v-for="[title, tables] in channels">
        <h3 v-if="title" class="nc-title">{{ title }}</h3>
        <table v-for="[heads, rows, lines] in tables" class="nc-times">
          <thead><tr><th v-for="head in heads" scope="col">{{ head }}</th></tr></thead>
          <tbody>
            <tr v-for="(row, index) in rows" v-bind="lines[index] ? act : {}"
              @click="choose(lines[index])" @keydown.enter="choose(lines[index])">
              <td v-for="cell in row">{{ cell }}</td>
            </tr>
          </tbody>
        </table>
      </div>
    </div>`,
  props: { channels: Array },
  methods: {
    choose(line) {
      if (line) this.$emit("line", line);
    },
  },
  data: () => ({ act: { tabindex: 0 } }),
};
