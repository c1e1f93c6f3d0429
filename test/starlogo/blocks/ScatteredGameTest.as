package starlogo.blocks
{
    import evaluation.scenes.ScatteredScene;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.models.ColladaModel;
    import starlogo.models.ObjModel;
    import support.Fixtures;

    /** How many collisions each system finds, finds falsely and misses in the game that the playground compares them by. */
    public class ScatteredGameTest
    {
        public static const FIXTURES:Array = ["/fixtures/playground/scattered.json", "/assets/bear.obj", "/assets/fortress.obj", "/assets/dragon.dae", "/assets/fireman.dae",
                "/assets/seagull.dae", "/assets/person.dae"];

        private static const CAST:Array = ["bear", "dragon", "fireman", "seagull", "fortress", "person"];

        [Test]
        public function countsAreThoseThatThePlaygroundShows():void
        {
            var scene:ScatteredScene = new ScatteredScene(150, CAST, 5);
            for (var i:int = 0; i < scene.agents.length; i += 2)
            {
                scene.agents[i].hierarchical = true;
            }
            var blocks:CollisionBlocks = new CollisionBlocks(models(), scene.agents);
            var expected:Array = JSON.parse(Fixtures.text(FIXTURES[0])).frames;
            assertEquals(3, expected.length);
            for each (var frame:Object in expected)
            {
                var truth:Object = pairsOf(blocks, CollisionBlocks.EXACT);
                assertEquals(frame.touching, count(truth, null));
                assertTrue("some touch", frame.touching > 20);
                for each (var name:String in CollisionBlocks.systemNames)
                {
                    var pairs:Object = pairsOf(blocks, name);
                    if (name != CollisionBlocks.EXACT)
                    {
                        assertEquals(name, frame[name].join(), [count(pairs, null), count(pairs, truth), count(truth, pairs)].join());
                    }
                }
                useHulls(scene.agents, Agent.HULL);
                pairs = pairsOf(blocks, CollisionBlocks.TIGHTEST_FITS);
                assertEquals("hulls", frame.hulls.join(), [count(pairs, null), count(pairs, truth), count(truth, pairs)].join());
                useHulls(scene.agents, Agent.TIGHTEST);
                scene.step();
            }
        }

        private static function useHulls(agents:Vector.<Agent>, collideAs:String):void
        {
            for each (var agent:Agent in agents)
            {
                agent.collideAs = collideAs;
            }
        }

        private static function models():GreatLand
        {
            var greatLand:GreatLand = new GreatLand();
            for (var i:int = 1; i < FIXTURES.length; i++)
            {
                var file:String = FIXTURES[i].split("/").pop();
                var name:String = file.split(".")[0];
                greatLand.addModel(file.split(".")[1] == "obj" ? new ObjModel(name, Fixtures.text(FIXTURES[i])) : new ColladaModel(name, Fixtures.text(FIXTURES[i])));
            }
            return greatLand;
        }

        private static function pairsOf(blocks:CollisionBlocks, system:String):Object
        {
            var found:Vector.<Agent> = blocks.systemNamed(system).findCollisions(blocks.agents);
            var pairs:Object = {};
            for (var i:int = 0; i < found.length; i += 2)
            {
                pairs[Math.min(found[i].id, found[i + 1].id) + " " + Math.max(found[i].id, found[i + 1].id)] = true;
            }
            return pairs;
        }

        // How many of the pairs are not among the others.
        private static function count(pairs:Object, others:Object):int
        {
            var number:int = 0;
            for (var pair:String in pairs)
            {
                number += others == null || !others[pair] ? 1 : 0;
            }
            return number;
        }
    }
}
