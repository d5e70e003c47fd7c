// The playground: games in which a person is one of the agents, and conflicts on a small board
// under any rules.

import "./playground.css";
import { loadEngine } from "../engine/engine.ts";
import { hasAddress, html, started } from "../page/dom.ts";
import { top } from "../page/top.ts";
import { followAddress, hash, isMatch, storeOf } from "./address.ts";
import { pageData } from "./data.ts";
import { GAMES, Games } from "./play_view.ts";
import { sceneView } from "./scene_view.ts";

const TABS = { ...GAMES, scene: "Rules and conflicts" } as const;
type Tab = keyof typeof TABS;

const LEAD = {
  games: "You move one agent. Scripts, or policies that evolved, move all others.",
  scene: "Give agents their moves, predict what happens, and play the step.",
};

async function show(root: HTMLElement): Promise<void> {
  const data = pageData();
  const engine = await loadEngine();
  const link = hash();
  const { store, problem } = storeOf(engine, data, isMatch(link) ? data.scene : link || data.scene);
  const games = data.play && new Games(engine, data.play);
  let tab: Tab = "scene";
  const scene = sceneView(store, () => tab === "scene");
  const lead = html("span");
  const names = Object.keys(TABS) as Tab[];
  const buttons = names.map((name) =>
    html(
      "button",
      { type: "button", onclick: () => (name === "scene" ? showTab(name) : games!.begin(name)) },
      TABS[name],
    ),
  );
  const showTab = (next: Tab): void => {
    tab = next;
    const atScene = tab === "scene";
    names.forEach((name, place) => buttons[place]!.setAttribute("aria-pressed", String(name === tab)));
    for (const each of [scene.element, ...scene.tools]) each.hidden = !atScene;
    if (games) games.element.hidden = atScene;
    lead.textContent = atScene ? LEAD.scene : LEAD.games;
    if (atScene) games?.view.stop();
    else store.stop();
    if (!hasAddress()) return;
    if (atScene) {
      store.dispatchEvent(new Event("change")); // which writes the address
    } else {
      history.replaceState(null, "", location.href.split("#")[0]);
    }
  };
  const follow = (address: string): boolean =>
    isMatch(address) && Boolean(games?.follow(new URLSearchParams(address)));
  games?.addEventListener("game", () => showTab(games.game));
  root.classList.add("playground");
  root.replaceChildren(
    top("Playground", lead, ...scene.tools),
    html("nav", { class: "tabs buttons", "aria-label": "What to play", hidden: !games }, ...buttons),
    html("main", {}, games && games.element, scene.element),
    html("footer", { class: "muted small" }, `${data.title} · matrixworld ${data.version}`),
    scene.dialog,
  );
  document.addEventListener(
    "keydown",
    (event) => tab !== "scene" && games!.view.key(event) && event.preventDefault(),
  );
  if (hasAddress()) {
    followAddress(
      store,
      () => tab === "scene",
      () => showTab("scene"),
    );
  }
  window.addEventListener("hashchange", () => follow(hash()));
  if (!follow(link)) {
    if (games && !data.scene && (!link || isMatch(link))) games.begin("escape");
    else showTab("scene");
  }
  if (problem) store.say(problem, true);
  Object.assign(window, { playground: store, matrixworldPlay: games?.view }); // for tests, and for the curious
}

void started(show(document.getElementById("page")!));
