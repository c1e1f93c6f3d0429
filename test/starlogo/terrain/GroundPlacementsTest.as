package starlogo.terrain
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.AgentPieces;
    import support.Complaints;
    import support.EachCollider;
    import support.Effort;
    import support.GroundReference;
    import support.RandomGround;
    import support.SolidModels;

    import flash.geom.Vector3D;

    /** Agents of all systems at random places on random ground, standing and sweeping, against every triangle of the ground. */
    public class GroundPlacementsTest
    {
        private static const MODELS:Array = ["cube", "sphere", "cylinder", "apart", "hollow"];

        private var _land:GreatLand;
        private var _models:Object;
        private var _colliders:Object;
        private var _wrong:Complaints;
        private var _random:SeededRandom;

        [Before]
        public function makeLand():void
        {
            _land = new GreatLand();
            _models = {};
            _colliders = {};
            _wrong = new Complaints();
            _random = new SeededRandom(38);
            for each (var model:Model in [BuiltInModel.cube(), BuiltInModel.sphere(), BuiltInModel.cylinder(), SolidModels.apart(), SolidModels.hollow()])
            {
                _land.addModel(model);
                _models[model.name] = model;
            }
            for each (var name:String in EachCollider.NAMES)
            {
                _colliders[name] = EachCollider.make(name, _land);
            }
        }

        [Test]
        public function placesAreLikeEveryTriangle():void
        {
            var touches:int = 0;
            var count:int = Effort.choose(40, 25000, 8);
            for (var i:int = 0; i < count; i++)
            {
                var kind:String = RandomGround.KINDS[i % RandomGround.KINDS.length];
                var terrain:Terrain = RandomGround.make(kind, _random);
                var reference:GroundReference = new GroundReference(terrain);
                for (var k:int = 0; k < 8; k++)
                {
                    var agent:Agent = randomAgent(terrain);
                    for each (var name:String in EachCollider.NAMES)
                    {
                        touches += checkPlace(name, agent, terrain, reference, kind + " " + i + "." + k);
                    }
                }
            }
            var share:Number = touches / (count * 40);
            _wrong.assertNone();
            assertTrue("share of touches: " + share, share > 0.2 && share < 0.8);
        }

        [Test]
        public function waysAreLikeEveryTriangle():void
        {
            var hits:int = 0;
            var count:int = Effort.choose(16, 10000, 8);
            for (var i:int = 0; i < count; i++)
            {
                var kind:String = RandomGround.KINDS[i % RandomGround.KINDS.length];
                var terrain:Terrain = RandomGround.make(kind, _random);
                var reference:GroundReference = new GroundReference(terrain);
                for each (var name:String in EachCollider.NAMES)
                {
                    for (var k:int = 0; k < 2; k++)
                    {
                        hits += checkWay(name, randomAgent(terrain), terrain, reference, kind + " " + i + "." + k);
                    }
                }
            }
            var share:Number = hits / (count * 10);
            _wrong.assertNone();
            assertTrue("share of hits: " + share, share > 0.2 && share < 0.9);
        }

        private function randomAgent(terrain:Terrain):Agent
        {
            var agent:Agent = new Agent(MODELS[_random.integer(0, MODELS.length - 1)]);
            var width:Number = terrain.cellWidth;
            agent.hierarchical = _random.chance();
            agent.size = _random.chance(0.3) ? width * _random.logBetween(0.001, 20) : width * _random.logBetween(0.2, 4);
            if (_random.chance(0.7))
            {
                agent.heading = _random.between(0, 360);
                agent.pitch = _random.between(-90, 90);
                agent.roll = _random.between(-90, 90);
            }
            var x:Number = terrain.x + width * _random.between(-2, terrain.columns + 1);
            var y:Number = terrain.y + width * _random.between(-2, terrain.rows + 1);
            if (_random.chance(0.2))
            {
                // on seams
                x = terrain.x + width * _random.integer(-1, 2 * terrain.columns) / 2;
                y = terrain.y + width * _random.integer(-1, 2 * terrain.rows) / 2;
            }
            var height:Number = terrain.heightAt(x, y);
            height = isNaN(height) ? terrain.getHeight(0, 0) : height;
            agent.moveTo(x, y, height + agent.size * _random.between(-1.5, 1) + width * _random.between(-0.2, 0.5));
            return agent;
        }

        // Returns whether the two touch.
        private function checkPlace(name:String, agent:Agent, terrain:Terrain, reference:GroundReference, where:String):int
        {
            var gap:Number = reference.gapOf(pieces(name, agent), 0, 0, 0, 2 * nearOf(agent, terrain));
            var areTouching:Boolean = _colliders[name].areColliding(agent, terrain.agent);
            _wrong.addIf(areTouching != gap <= 0 && (gap == 0 || Math.abs(gap) > nearOf(agent, terrain)),
                    name, where + ", " + describe(agent, terrain) + ", gap " + gap);
            if (areTouching)
            {
                checkContact(name, agent, terrain, reference, where);
            }
            return areTouching ? 1 : 0;
        }

        // Moved by a little more than the depth, the agent is free. Moved by a little less, it still touches.
        private function checkContact(name:String, agent:Agent, terrain:Terrain, reference:GroundReference, where:String):void
        {
            var contact:Contact = _colliders[name].contactOf(agent, terrain.agent);
            // Not more than rounding: a little farther on, the way may lead into another part of the ground.
            var near:Number = 5e-9 * (agent.size + terrain.cellWidth) + 5e-14 * (Math.abs(terrain.x) + 1000);
            var more:Number = gapAlong(contact.normal, contact.depth + near, name, agent, reference, near);
            var less:Number = gapAlong(contact.normal, contact.depth - near, name, agent, reference, near);
            // beside a needle the gap grows by a ten-thousandth of the way, so it may be as small as rounding errors
            if (!(Math.abs(contact.normal.length - 1) < 1e-12) || more <= 0 || less > 1e-12 + 5e-15 * Math.abs(terrain.x) && contact.depth > near)
            {
                _wrong.add(name + ", contact", where + ", " + describe(agent, terrain) + ", depth " + contact.depth + " along " + contact.normal + ", gaps " + [less, more]);
            }
        }

        private function gapAlong(way:Vector3D, by:Number, name:String, agent:Agent, reference:GroundReference, most:Number):Number
        {
            return reference.gapOf(pieces(name, agent), by * way.x, by * way.y, by * way.z, most);
        }

        private function checkWay(name:String, agent:Agent, terrain:Terrain, reference:GroundReference, where:String):int
        {
            var far:Number = agent.size + terrain.cellWidth;
            var motion:Vector3D = new Vector3D(_random.normal() * far, _random.normal() * far, -Math.abs(_random.normal()) * far);
            agent.z += far;
            var expected:Number = reference.timeOf(pieces(name, agent), motion, nearOf(agent, terrain) / 1000);
            var collision:Collision = new Collision(_colliders[name]);
            var time:Number = Infinity;
            collision.terrain = terrain;
            collision.onCollision("turtles", Collision.TERRAIN, function(collider:Agent, collidee:Agent, contact:Object):void
                {
                    assertTrue(collidee === terrain.agent);
                    time = contact.time;
                });
            agent.sweeps = true;
            collision.update(new <Agent>[agent]);
            var stood:Number = time;
            time = Infinity;
            agent.moveTo(agent.x + motion.x, agent.y + motion.y, agent.z + motion.z);
            collision.update(new <Agent>[agent]);
            // the collider may then have another Collision
            collision.collisionSystem = new BinCollider();
            if (stood < Infinity)
            {
                expected = 0;
            }
            if (expected != time && !(Math.abs(expected - time) * motion.length < 1e4 * nearOf(agent, terrain)))
            {
                // grazing: it has to come clearly nearer
                _wrong.addIf(isDeeper(name, agent, motion, reference, Math.min(expected, time), nearOf(agent, terrain)),
                        name, where + ", " + describe(agent, terrain) + " along " + motion + ": " + time + " instead of " + expected);
            }
            return time <= 1 ? 1 : 0;
        }

        // Whether, a little after a time, the agent, which is at the end of its way, is deeper in the ground than rounding comes to, or there is none at all.
        private function isDeeper(name:String, agent:Agent, motion:Vector3D, reference:GroundReference, time:Number, near:Number):Boolean
        {
            var back:Number = time + 100 * near / motion.length - 1;
            return gapAlong(motion, back, name, agent, reference, near) < 0;
        }

        // Beneath it rounding decides.
        private static function nearOf(agent:Agent, terrain:Terrain):Number
        {
            return 1e-9 * (agent.size + terrain.cellWidth) + 1e-12 * (Math.abs(terrain.x) + 1000);
        }

        private function pieces(name:String, agent:Agent):Array
        {
            return AgentPieces.of(name, agent, _land, _models[agent.shape]);
        }

        private static function describe(agent:Agent, terrain:Terrain):String
        {
            return agent + " of size " + agent.size + " at (" + agent.x + ", " + agent.y + ", " + agent.z + ") turned " + agent.heading + ", " + agent.pitch + ", "
                + agent.roll + " on " + terrain.columns + " by " + terrain.rows + (terrain.isBlocky ? " columns" : " slopes") + " of " + terrain.cellWidth;
        }
    }
}
