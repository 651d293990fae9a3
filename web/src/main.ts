/** Starts the page: chooses the drawing profile, then plays the recording if there is one, or else the live run. */

import '@fontsource/barlow-semi-condensed/latin-500.css';
import '@fontsource/barlow-semi-condensed/latin-600.css';
import './style/tokens.css';
import './style/layout.css';
import './style/controls.css';
import './panel/rail/rail.css';
import './panel/rail/menus.css';
import './panel/monitors/monitors.css';
import './panel/monitors/inset.css';
import './panel/spine/spine.css';
import './panel/desk/desk.css';
import './panel/desk/hands.css';
import './panel/joints/tables.css';
import './panel/desk/events.css';
import './panel/clearance/clearance.css';
import './panel/effector/effector.css';
import './panel/console/console.css';
import './panel/controllers/key-map.css';
import './panel/target/control-page.css';
import './panel/controllers/controllers.css';
import './panel/controllers/touch.css';
import './page/readiness.css';
import './page/opening.css';
import './task/task.css';
import './panel/calm/calm.css';
import './cameras/all-cameras.css';
import './windows/planes.css';
import './replay/replay.css';
import './replay/timeline.css';
import './style/night.css';
import './style/forced.css';
import { present } from './basics/assert';
import { fly } from './link/live';
import { notice } from './page/notice';
import { chooseDrawing } from './page/quality';
import { play } from './replay';
import { recordingHere } from './replay/source';

const root = present(document.getElementById('page'), 'The element #page');
const drawing = chooseDrawing(location.search);
const recording = recordingHere(document);
if (!drawing) {
  notice(root, 'The station draws with WebGL 2, which this browser does not offer or has switched off.');
} else if (recording) {
  play(root, drawing, recording);
} else {
  fly(root, drawing);
}
