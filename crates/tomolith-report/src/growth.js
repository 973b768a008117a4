
for (const growth of document.querySelectorAll(".growth")) {
  const buttons = [...growth.querySelectorAll("[type=radio]")];
  const range = growth.querySelector("[type=range]");
  const say = () => range.setAttribute("aria-valuetext", buttons[range.value].labels[0].textContent);
  // A browser may remember the button of an earlier visit
  range.value = Math.max(0, buttons.findIndex((button) => button.checked));
  range.oninput = () => { buttons[range.value].checked = true; say(); };
  range.parentElement.hidden = false;
  growth.classList.add("slides");
  say();
}
