// The view of the method: the equations of the model, its symbols, the two readings of a coupling, and the
// works to cite.
import { html, LitElement, nothing } from "lit";
import { unsafeHTML } from "lit/directives/unsafe-html.js";
import "../terms/term";
import { download } from "../ui/download";
import { EQUATION_NAMES, EQUATIONS, SYMBOLS } from "./equations";
import { graphs } from "./graphs";
import "./method.css";
import { modelTable } from "./model-table";
import { bibtex, FURTHER_WORKS, inWords, MODEL_PAPERS, type Work } from "./references";
import { SYMBOL_ROWS } from "./symbols";

const equation = (name: keyof typeof EQUATIONS) =>
  html`<div class="equation" tabindex="0" role="region" aria-label="Equation: ${EQUATION_NAMES[name]}">${unsafeHTML(EQUATIONS[name])}</div>`;

export class MethodPage extends LitElement {
  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  #show(place: string): void {
    this.dispatchEvent(new CustomEvent("show-place", { detail: place, bubbles: true }));
  }

  #model() {
    return html`
      <section class="panel">
        <h2>The model</h2>
        ${graphs((place) => this.#show(place))}
        <p>A body is split into parts. Each frame of part i is a <pg-term of="latent" text="latent"></pg-term>, a point in a space of Q dimensions. Where the latent goes next is
          predicted by every part j from its own last frames, and the predictions are combined as a <pg-term of="product-of-experts" text="product of experts"></pg-term>:</p>
        ${equation("dynamics")}
        ${equation("weights")}
        ${equation("history")}
        <p>The smaller a coupling variance, the larger the weight of that expert. Only ratios of the variances into one part change the mean.
          Each expert is a Gaussian process. Its signal variance is 1: otherwise its scale could be traded for its weight.</p>
        ${equation("expert")}
        ${equation("kernel")}
        <p>A <pg-term of="pose-map" text="pose map"></pg-term>, a Gaussian process too, turns the latent into the pose of the part:</p>
        ${equation("pose")}
      </section>
      <section class="panel">
        <h2>Training</h2>
        <p>The latents are not known, so training finds a Gaussian distribution for each, together with kernels, couplings and inducing points.
          It climbs a lower bound on the log evidence:</p>
        ${equation("bound")}
        <p>Each term F of a Gaussian process rests on a few inducing points in place of all frames (Titsias and Lawrence 2010). For R rows and C
          columns, with the variance n of what is observed and the covariance K of the inducing points:</p>
        ${equation("collapsed")}
        ${equation("posterior")}
        <p>Ψ₂ and b sum over the frames what the kernel is expected to be, and what it is expected to be times the target; c₂ is the expected square
          of the targets, and Δ what the inducing points leave unexplained. The time of an iteration grows linearly with the frames.</p>
      </section>
      <section class="panel">
        <h2>Where the bound comes from</h2>
        <ol class="works">
          <li>Each map gets inducing points: a few inputs, and the outputs there. Given these outputs, the rest of the map does not depend on the data.</li>
          <li>The true distribution of latents and outputs is replaced by one that factorises: a Gaussian for each latent, and one for the outputs of each map.
            Jensen’s inequality then bounds the log evidence from below.</li>
          <li>The maps are integrated out. The best distribution of the inducing outputs has a closed form, the equation of <b>E</b>(u) above, so that it is never searched.</li>
          <li>Kernel values are averaged over the Gaussian latents. For this kernel the averages are exact, so that nothing is sampled, and the gradient follows.</li>
        </ol>
      </section>
      <section class="panel">
        <h2>Rollout</h2>
        <p>A rollout starts with the first p latents of a clip and then predicts frame after frame, all parts together:</p>
        ${equation("rollout")}
        <p>This is the mean; nothing random is in it.</p>
      </section>
      <section class="panel">
        <h2>Two readings of a coupling</h2>
        <p><strong>Experts as learned.</strong> A slider changes α and so the weights. What each expert predicts stays as it is. This asks: what if
          this part listened less to that one?</p>
        <p><strong>Experts re-inferred.</strong> Under other couplings the same data would have taught other experts. The model keeps the sums Ψ₂ and b,
          so that <b>E</b>(u) can be computed again for any α, with the equation above. This asks: could the data be explained under these couplings?
          Often they can, and the motion stays nearly the same.</p>
        <button class="small" @click=${() => this.#show("reading")}>Choose the reading</button>
      </section>`;
  }

  #others() {
    return html`
      <section class="panel">
        <h2>The other models</h2>
        ${modelTable()}
        <p><pg-term of="tmp" text="TMP"></pg-term>: every column is a weighted sum of a few curves over a common phase.</p>
        ${equation("tmp")}
        <p><pg-term of="dmp" text="DMP"></pg-term>: a spring pulls every column towards a goal g, and a learned force f follows a given clock s.</p>
        ${equation("dmp")}
        <p><pg-term of="map" text="MAP"></pg-term>: the same dynamics as above, with all frames in place of inducing points, and the most probable latents in place of distributions.</p>
        ${equation("map")}
        <h3>The perception score</h3>
        <p>How often people take a model’s movement for the natural one falls with its error. Velychko et al. (2018) fit a and c; 0.5 would be perfect.</p>
        ${equation("score")}
      </section>`;
  }

  #symbols() {
    return html`
      <section class="panel">
        <h2>The symbols, and where they are on the page</h2>
        <div class="table-box" tabindex="0" role="region" aria-label="Symbols">
          <table class="symbols">
            <thead><tr><th scope="col">Symbol</th><th scope="col">Meaning</th><th scope="col">On the page</th></tr></thead>
            <tbody>${SYMBOL_ROWS.map(
              ({ symbol, meaning, place, there }) => html`
              <tr><td>${unsafeHTML(SYMBOLS[symbol])}</td><th scope="row">${meaning}</th>
                <td>${place ? html`<button class="small" data-place=${place} @click=${() => this.#show(place)}>${there}</button>` : html`<small>not shown</small>`}</td></tr>`,
            )}</tbody>
          </table>
        </div>
      </section>`;
  }

  #work(work: Work) {
    const { doi } = work;
    return html`<li>${inWords(work)} ${doi ? html`<a href="https://doi.org/${doi}">doi:${doi}</a>` : nothing}</li>`;
  }

  #references() {
    const entries = MODEL_PAPERS.map(bibtex).join("\n\n");
    const save = () => download("vcgpdm.bib", new Blob([`${entries}\n`], { type: "text/plain" }));
    return html`
      <section class="panel">
        <h2>References</h2>
        <ol class="works">${[...MODEL_PAPERS, ...FURTHER_WORKS].map((work) => this.#work(work))}</ol>
        <h3>Cite this</h3>
        <p>If you use this page or its programs, please cite the papers whose model they implement.</p>
        <pre class="bibtex" tabindex="0" role="region" aria-label="BibTeX" data-testid="bibtex">${entries}</pre>
        <button class="small" data-testid="save-bibtex" @click=${save}>Save as BibTeX</button>
      </section>`;
  }

  protected override render() {
    return html`<div class="method">${this.#model()}${this.#others()}${this.#symbols()}${this.#references()}
      <p><button @click=${() => this.#show("stage")}>Back to the walk</button></p></div>`;
  }
}
customElements.define("pg-method", MethodPage);
