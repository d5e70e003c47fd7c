/* built from web/ by "npm run build"; sources 47d29fc6c6eac5e249786b01bbb736016819622a958ff68cacaca7a900b195eb */
"use strict";(()=>{document.body.dataset.ready="true";})();
