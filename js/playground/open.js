// A browser loads no modules for a page that no server sent. The file beside this one needs none.
if (location.protocol === "file:") location.replace(`starlogo-nova.html${location.search}${location.hash}`);
