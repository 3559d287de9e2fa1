// Begins the page of one manifold, whose data are in it.
function main() {
  try {
    const data = JSON.parse(element('manifold-data').textContent);
    showFacts(data);
    const pages = location.hash.slice(1).split('|').map((fragment) => {
      const page = new Page(data, fragment);
      page.start();
      page.canvas.focus({preventScroll: true});  // so that keys are heard at once
      return page.wishes.has('dump') ? dump(page) : null;
    });
    if (pages.some((page) => page)) writeDump(pages);
  } catch (error) {
    showNotice(`This page has failed: ${error.message}`);
    throw error;
  }
}
main();
