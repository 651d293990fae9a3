/** Boot: choose how to draw; play where there is a recording, else fly. */

import '@fontsource/barlow-semi-condensed/latin-500.css';
import '@fontsource/barlow-semi-condensed/latin-600.css';
import './style/tokens.css';
import './style/layout.css';
import './style/controls.css';
import './style/monitors.css';
import './style/spine.css';
import './style/desk.css';
import './style/hands.css';
import './style/tables.css';
import './style/clearance.css';
import './style/effector.css';
import './style/key-map.css';
import './style/control-page.css';
import './style/controllers.css';
import './style/touch.css';
import './style/tutorial.css';
import './style/replay.css';
import './style/timeline.css';
import './style/all-cameras.css';
import './style/narrow.css';
import './style/watching.css';
import './style/night.css';
import { present } from './assert';
import { fly } from './live';
import { notice } from './notice';
import { chooseDrawing } from './quality';
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
