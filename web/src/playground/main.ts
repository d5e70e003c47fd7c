import "./playground.css";

document.body.dataset["ready"] = "true";
