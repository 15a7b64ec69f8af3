// SPDX-License-Identifier: MIT
// Tables of times: for each channel its title and tables; a table is heads, rows and the lines of its first rows, 0 where one is not in the program shown. A click, or Enter, on a row tells its line.
export default {
  template: `
    <div>
      <div v-for="[title, tables] in channels">
        <h3 v-if="title" class="nc-title">{{ title }}</h3>
        <table v-for="[heads, rows, lines] in tables" class="nc-times">
          <thead><tr><th v-for="head in heads" scope="col">{{ head }}</th></tr></thead>
          <tbody>
            <tr v-for="(row, index) in rows" v-bind="lines[index] ? act : {}"
              @click="tell(lines[index])" @keydown.enter="tell(lines[index])">
              <td v-for="cell in row">{{ cell }}</td>
            </tr>
          </tbody>
        </table>
      </div>
    </div>`,
  props: { channels: Array },
  methods: {
    tell(line) {
      if (line) this.$emit("line", line);
    },
  },
  data: () => ({ act: { tabindex: 0 } }),
};
