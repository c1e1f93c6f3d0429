package starlogo.blocks
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collider;
    import starlogo.collision.CollisionSystem;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import support.Fixtures;
    import support.SurfaceDistance;
    import support.TransformedStructure;
    import support.assertThrows;
    import support.create;
    import support.landOf;

    public class StructureBlocksTest
    {
        public static const FIXTURES:Array = ["/assets/bear.obj", "/assets/kelp.obj"];

        private static const SHAPES:Array = ["sphere", "cube", "cylinder", "bear", "kelp"];

        private static var sGreatLand:GreatLand;

        // has kept every kind
        private static var sThorough:GreatLand;

        private static var sModels:Object;

        private var _agents:Vector.<Agent> = new <Agent>[];
        private var _collisions:CollisionBlocks = new CollisionBlocks(sGreatLand, _agents);
        private var _blocks:StructureBlocks = new StructureBlocks(_collisions);

        [BeforeClass]
        public static function load():void
        {
            sGreatLand = new GreatLand();
            sThorough = new GreatLand();
            sThorough.loadAllBoundingStructures = sThorough.loadHulls = true;
            sModels = {};
            for each (var model:Model in [BuiltInModel.sphere(), BuiltInModel.cube(), BuiltInModel.cylinder(),
                        new ObjModel("bear", Fixtures.text(FIXTURES[0])), new ObjModel("kelp", Fixtures.text(FIXTURES[1]))])
            {
                sModels[model.name] = model;
                sGreatLand.addModel(model);
                sThorough.addModel(model);
            }
        }

        [Test]
        public function linesLieOnWhatTheyShow():void
        {
            var random:SeededRandom = new SeededRandom(14);
            var kinds:Array = TraitBlocks.structureNames;
            var drawn:Object = {};
            for (var i:int = 0; i < 100; i++)
            {
                var agent:Agent = randomAgent(random);
                agent.collideAs = kinds[i % kinds.length];
                agent.hierarchical = i % 3 == 0;
                agent.traversalDepth = i % 5;
                for each (var system:String in CollisionBlocks.systemNames)
                {
                    _collisions.useCollisionSystem(system);
                    var structures:Vector.<BoundingStructure> = structuresOf(agent, system);
                    var lines:Vector.<Number> = _blocks.linesOf(agent);
                    assertTrue(lines.length > 0 && lines.length % 6 == 0);
                    drawn[structures.length > 1 ? "level" : String(structures[0].kind)] = true;
                    // of many lines, some
                    var stride:int = 3 * int(1 + lines.length / 3 / (structures.length > 30 ? 8 : 80));
                    for (var j:int = 0; j < lines.length; j += stride)
                    {
                        var gap:Number = distanceTo(structures, new Vector3D(lines[j], lines[j + 1], lines[j + 2]));
                        assertTrue(agent + " in " + system + ": an end is " + gap + " off", gap < 1e-6 * Math.max(1, agent.size));
                    }
                }
            }
            assertTrue("levels, spheres, capsules and boxes", drawn["level"] && drawn["0"] && drawn["1"] && drawn["2"]);
        }

        [Test]
        public function whatIsShownIsChosenByAgentOrBreed():void
        {
            var random:SeededRandom = new SeededRandom(3);
            for (var i:int = 0; i < 4; i++)
            {
                _agents.push(randomAgent(random));
            }
            _agents[0].breed = _agents[1].breed = "bears";
            assertEquals(0, _blocks.lines().length);
            _blocks.show("bears", true);
            _blocks.show(_agents[3], true);
            _blocks.show("bears", true);
            assertEquals("true,true,false,true", shown());
            var length:int = _blocks.linesOf(_agents[0]).length + _blocks.linesOf(_agents[1]).length + _blocks.linesOf(_agents[3]).length;
            assertEquals(length, _blocks.lines().length);
            var lines:Vector.<Number> = new <Number>[1, 2, 3, 4, 5, 6];
            assertEquals(length + 6, _blocks.lines(lines).length);
            _blocks.show("bears", false);
            assertEquals("false,false,false,true", shown());
            _blocks.showNone();
            assertEquals("false,false,false,false", shown());
        }

        [Test]
        public function shapesOfTheGamesOwnAreShown():void
        {
            var agent:Agent = new Agent("cube");
            agent.pitch = 90;
            agent.moveTo(1, 2, 3);
            for each (var system:CollisionSystem in [_collisions.systemNamed(CollisionBlocks.TIGHTEST_FITS), new Collider(new Bubbles(sGreatLand))])
            {
                _collisions.collision.collisionSystem = system;
                var lines:Vector.<Number> = _blocks.linesOf(agent);
            }
            assertTrue(lines.length > 12 * 6);
            // the bubble's middle is half a patch beside the agent's place, because it has turned with the agent
            for (var i:int = 0; i < lines.length; i += 3)
            {
                var distance:Number = Vector3D.distance(new Vector3D(lines[i], lines[i + 1], lines[i + 2]), new Vector3D(1.5, 2, 3));
                assertTrue("distance " + distance, Math.abs(distance - 1) < 1e-9);
            }
        }

        [Test]
        public function anotherModelOfTheNameHasItsOwnLines():void
        {
            var greatLand:GreatLand = landOf(BuiltInModel.cube());
            _collisions = new CollisionBlocks(greatLand, _agents);
            _blocks = new StructureBlocks(_collisions);
            var agent:Agent = new Agent("cube");
            assertEquals(12 * 6, _blocks.linesOf(agent).length);
            greatLand.addModel(new ObjModel("cube", Fixtures.text(FIXTURES[0])));
            var low:Number = Infinity;
            var lines:Vector.<Number> = _blocks.linesOf(agent);
            for (var i:int = 2; i < lines.length; i += 3)
            {
                low = Math.max(low == Infinity ? 0 : low, lines[i]);
            }
            assertTrue("as high as the bear: " + low, low > 1.2);
        }

        [Test]
        public function wrongUsesSaySo():void
        {
            assertThrows(BlockError, /^The block "show bounding structures" needs an agent or a breed, but got nothing/, _blocks.show, null, true);
            assertThrows(ArgumentError, /collisions must not be null/, create, StructureBlocks, null);
            assertThrows(ArgumentError, /agent must/, _blocks.isShown, null);
        }

        [Test]
        public function aModelThatIsLoadingHasNone():void
        {
            sGreatLand.expect("late");
            assertEquals(0, _blocks.linesOf(new Agent("late")).length);
            sGreatLand.expectNoMore("late");
        }

        private function shown():String
        {
            var all:Array = [];
            for each (var agent:Agent in _agents)
            {
                all.push(_blocks.isShown(agent));
            }
            return all.join();
        }

        private static function randomAgent(random:SeededRandom):Agent
        {
            var agent:Agent = new Agent(SHAPES[int(random.between(0, SHAPES.length))]);
            agent.moveTo(random.between(-5, 5), random.between(-5, 5), random.between(-5, 5));
            agent.heading = random.between(0, 360);
            agent.pitch = random.between(0, 360);
            agent.roll = random.between(0, 360);
            agent.size = random.between(0.5, 3);
            return agent;
        }

        // What the lines must lie on, in the world, computed in another way.
        private static function structuresOf(agent:Agent, system:String):Vector.<BoundingStructure>
        {
            var structures:Vector.<BoundingStructure> = new Vector.<BoundingStructure>();
            if (system == CollisionBlocks.UNIT_SPHERES)
            {
                structures.push(new Sphere(new Vector3D(agent.x, agent.y, agent.z + agent.size / 2), agent.size / 2));
                return structures;
            }
            if (system == CollisionBlocks.EXACT)
            {
                var vertices:Vector.<Number> = sModels[agent.shape].vertices;
                for (var j:int = 0; j < vertices.length; j += 3)
                {
                    structures.push(new Sphere(new Vector3D(vertices[j], vertices[j + 1], vertices[j + 2]), 0));
                }
            }
            else if (system == CollisionBlocks.HIERARCHIES || (system == CollisionBlocks.COMBINATION && agent.hierarchical))
            {
                addLevel(sGreatLand.hierarchies.root(agent.shape), agent.traversalDepth || 5, structures);
            }
            else
            {
                structures.push(kindOf(agent));
            }
            for (var i:int = 0; i < structures.length; i++)
            {
                structures[i] = TransformedStructure.of(structures[i], agent);
            }
            return structures;
        }

        private static function kindOf(agent:Agent):BoundingStructure
        {
            if (agent.collideAs == Agent.TIGHTEST)
            {
                return sGreatLand.boundingStructures.tightestFit(agent.shape);
            }
            var kept:BoundingStructuresLibrary = sThorough.boundingStructures;
            switch (agent.collideAs)
            {
                case Agent.SPHERE:
                    return kept.sphere(agent.shape);
                case Agent.BOX:
                    return kept.box(agent.shape);
                case Agent.HULL:
                    return kept.hull(agent.shape);
                default:
                    return kept.capsule(agent.shape);
            }
        }

        private static function addLevel(node:HierarchyNode, levels:int, out:Vector.<BoundingStructure>):void
        {
            if (levels == 1 || node.isLeaf)
            {
                out.push(node.bounds);
                return;
            }
            addLevel(node.left, levels - 1, out);
            addLevel(node.right, levels - 1, out);
        }

        private static function distanceTo(structures:Vector.<BoundingStructure>, point:Vector3D):Number
        {
            var least:Number = Infinity;
            for (var i:int = 0; i < structures.length; i++)
            {
                least = Math.min(least, SurfaceDistance.of(structures[i], point));
            }
            return least;
        }
    }
}

import flash.geom.Vector3D;
import starlogo.GreatLand;
import starlogo.agents.Agent;
import starlogo.bounding.Sphere;
import starlogo.search.ModelShape;
import starlogo.search.ShapeChoice;

/** Every agent is a sphere twice as wide as the agent. */
internal class Bubbles extends ShapeChoice
{
    public function Bubbles(greatLand:GreatLand)
    {
        super(greatLand);
    }

    override public function bind(shape:ModelShape, agent:Agent):void
    {
        shape.setStructure(new Sphere(new Vector3D(0, 0, 0.5), 1));
    }
}
