import "./explorer.css";

document.body.dataset["ready"] = "true";
