/** What the pages' samples in JavaScript may name without showing it: the game of the README's first sample. */
import { engine } from './engine.mjs';

const { Agent, BuiltInModel, Collision, GreatLand, TightestFitCollider } = engine;
export const greatLand = new GreatLand();
greatLand.addModel(BuiltInModel.sphere());
export const bear = new Agent('sphere', 'bears');
export const ball = new Agent('sphere', 'paintballs');
ball.size = 0.2;
export const agents = [bear, ball];
export const collision = new Collision(new TightestFitCollider(greatLand));
