import {App} from './app.js';
import {FlatStage} from './flat_stage.js';

new App(FlatStage);
