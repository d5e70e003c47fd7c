/* built from web/ by "npm run build"; sources 7876d13004eef433b7a92b21458c12ee2230bc6aa2041f2f132bbdde016f9ce1 */
"use strict";(()=>{document.body.dataset.ready="true";})();
