/* built from web/ by "npm run build"; sources f0447ed45a2c8c1e2f28c7fde94d32b5e307042a7fe35771ed438998b7b489a4 */
"use strict";(()=>{document.body.dataset.ready="true";})();
