package starlogo.blocks
{
    import org.flexunit.asserts.assertEquals;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import support.assertThrows;
    import support.create;

    public class TraitBlocksTest
    {
        private var _bear:Agent = new Agent("bear", "bears");
        private var _otherBear:Agent = new Agent("bear", "bears");
        private var _ball:Agent = new Agent("sphere", "hasOwnProperty");
        private var _blocks:TraitBlocks = new TraitBlocks(new <Agent>[_bear, _otherBear, _ball]);

        [Test]
        public function anAgentAlone():void
        {
            _blocks.setHierarchical(_bear, true);
            _blocks.setCollisionDepth(_bear, 3);
            _blocks.collideAs(_bear, Agent.BOX);
            assertEquals("true 3 box", traitsOf(_bear));
            assertEquals("false 0 tightest", traitsOf(_otherBear));
        }

        [Test]
        public function aBreed():void
        {
            _blocks.setHierarchical("bears", true);
            _blocks.setCollisionDepth("bears", 3);
            _blocks.collideAs("bears", Agent.CAPSULE);
            assertEquals("true 3 capsule", traitsOf(_bear));
            assertEquals("true 3 capsule", traitsOf(_otherBear));
            assertEquals("false 0 tightest", traitsOf(_ball));
        }

        [Test]
        public function whoComesLaterGetsItsBreedsTraits():void
        {
            _blocks.setHierarchical("bears", true);
            _blocks.collideAs("bears", Agent.SPHERE);
            _blocks.setHierarchical("bears", false);
            _blocks.setCollisionDepth("hasOwnProperty", 2);
            var cub:Agent = new Agent("bear", "bears");
            cub.traversalDepth = 7;
            _blocks.welcome(cub);
            assertEquals("false 7 sphere", traitsOf(cub));
            var ball:Agent = new Agent("sphere", "hasOwnProperty");
            _blocks.welcome(ball);
            assertEquals("false 2 tightest", traitsOf(ball));
            var stranger:Agent = new Agent("bear", "toString");
            _blocks.welcome(stranger);
            assertEquals("false 0 tightest", traitsOf(stranger));
        }

        [Test]
        public function oneWay():void
        {
            _blocks.setOneWay(_bear, true);
            assertEquals("true false", _bear.isOneWay + " " + _otherBear.isOneWay);
            _blocks.setOneWay("bears", true);
            var cub:Agent = new Agent("bear", "bears");
            _blocks.welcome(cub);
            assertEquals("true true false", _otherBear.isOneWay + " " + cub.isOneWay + " " + _ball.isOneWay);
        }

        [Test]
        public function breedsAreForgotten():void
        {
            _blocks.collideAs("bears", Agent.SPHERE);
            _blocks.forgetBreeds();
            var cub:Agent = new Agent("bear", "bears");
            _blocks.welcome(cub);
            assertEquals("false 0 tightest", traitsOf(cub));
            assertEquals("false 0 sphere", traitsOf(_bear));
        }

        [Test]
        public function wrongUsesSaySoAndChangeNothing():void
        {
            assertThrows(BlockError, /^The block "collide as" does not know "ball"\. Choose one of these: tightest, sphere, box, capsule, hull\.$/,
                    _blocks.collideAs, "bears", "ball");
            assertThrows(BlockError, /^The block "collide as" needs an agent or a breed, but got nothing\. Remember: "collidee"/, _blocks.collideAs, null, "box");
            assertThrows(BlockError, /^The block "set hierarchical" needs an agent or a breed, but got 7\./, _blocks.setHierarchical, 7, true);
            assertThrows(BlockError, /^The block "set hierarchical" needs the name of a breed/, _blocks.setHierarchical, "", true);
            for each (var depth:Number in [-1, 1.5, NaN, Infinity])
            {
                assertThrows(BlockError, /^The block "set collision depth" needs a whole number: 1 is the coarsest/, _blocks.setCollisionDepth, "bears", depth);
            }
            for each (var breed:String in [Collision.ANY_BREED, Collision.TERRAIN, Collision.EDGE])
            {
                assertThrows(BlockError, /"one way" needs an agent or a breed of the game, not the ground/, _blocks.setOneWay, breed, true);
            }
            assertEquals("false 0 tightest", traitsOf(_bear));
            assertThrows(ArgumentError, /list of agents/, create, TraitBlocks, null);
            assertThrows(ArgumentError, /agent must/, _blocks.welcome, null);
        }

        private static function traitsOf(agent:Agent):String
        {
            return agent.hierarchical + " " + agent.traversalDepth + " " + agent.collideAs;
        }
    }
}
