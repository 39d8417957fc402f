import {App} from './app.js';
import {SolidStage} from './solid_stage.js';

new App(SolidStage);
