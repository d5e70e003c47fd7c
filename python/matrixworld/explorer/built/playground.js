/* built from web/ by "npm run build"; sources 6e5f6ab7c2b2dbe3364557e5e132419c7af65958945c4a3ee5daca24cd6aeaed */
"use strict";(()=>{document.body.dataset.ready="true";})();
