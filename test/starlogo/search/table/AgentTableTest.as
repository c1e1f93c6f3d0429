package starlogo.search.table
{
    import evaluation.pairs.SeededRandom;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collider;
    import starlogo.engine;
    import starlogo.models.BuiltInModel;
    import starlogo.queries.AgentQueries;
    import starlogo.search.TightestFitChoice;
    import support.EachCollider;
    import support.RandomWorlds;
    import support.assertThrows;
    import support.landOf;

    use namespace engine;

    /** A table has the agents that are listed, and no others: neither those that have left, nor those of a list that was refused. */
    public class AgentTableTest
    {
        private var _land:GreatLand = landOf(BuiltInModel.cube());
        private var _table:AgentTable = new AgentTable(new TightestFitChoice(_land));
        private var _agents:Vector.<Agent> = new Vector.<Agent>();

        [Before]
        public function makeTable():void
        {
            for (var i:int = 0; i < 20; i++)
            {
                _agents.push(new Agent("cube"));
            }
            _table.read(_agents);
        }

        [Test]
        public function hasNoneOfAListThatIsRefused():void
        {
            for (var i:int = 0; i < 50; i++)
            {
                var others:Vector.<Agent> = _agents.concat().reverse();
                others.splice(10, 5, new Agent("cube"), new Agent("cube"));
                assertThrows(ArgumentError, /null/, _table.read, others.concat(new <Agent>[null]));
                assertThrows(ArgumentError, /twice/, _table.read, others.concat(new <Agent>[others[0]]));
                assertHasOnly(_agents);
                for each (var agent:Agent in _agents)
                {
                    assertTrue(_table.listed.agentsByRow[_table.listed.rowOf(agent)] === agent);
                }
            }
            assertTrue(_table.listed.rowCapacity + " rows", _table.listed.rowCapacity <= 30);
            _table.read(_agents);
            assertHasOnly(_agents);
        }

        [Test]
        public function aRefusedListLeavesTheRowsAsTheyAre():void
        {
            var row:int = _table.listed.rowOf(_agents[3]);
            var breed:int = _table.breeds[row];
            _agents[3].breed = "wolf";
            _agents[3].moveTo(5, 0, 0);
            assertThrows(ArgumentError, /no model/, _table.read, _agents.concat(new <Agent>[new Agent("unknown")]));
            assertEquals(breed, _table.breeds[row]);
            assertEquals(0, _table.places.x[row]);
            _table.read(_agents);
            assertEquals(_agents[3].breedNumber, _table.breeds[row]);
            assertEquals(5, _table.places.x[row]);
        }

        /** A game's own bind() may add the model that another agent waits for. That agent's shape is then refused, when no row has changed yet. */
        [Test]
        public function aShapeThatIsRefusedLeavesTheRowsAsTheyAre():void
        {
            for each (var isOtherList:Boolean in [false, true])
            {
                var land:GreatLand = landOf(BuiltInModel.cube(), BuiltInModel.cylinder());
                var table:AgentTable = new AgentTable(new AddingChoice(land));
                land.expect("sphere");
                var agents:Vector.<Agent> = new <Agent>[new Agent("cube"), new Agent("sphere"), new Agent("cube"), new Agent("cube")];
                table.read(agents);
                var row:int = table.listed.rowOf(agents[0]);
                var rowOfLast:int = table.listed.rowOf(agents[3]);
                agents[0].size = 2;
                agents[2].shape = "cylinder";
                // bind() adds the sphere now, too late for this list
                table.read(agents);
                assertTrue(land.hasModel("sphere"));
                assertEquals(1, table.loadingCount);
                assertEquals(1, table.extents.halfX[row]);
                agents[0].size = 3;
                assertThrows(ArgumentError, /no shape/, table.read, isOtherList ? agents.slice(0, 3) : agents);
                assertEquals("as it was", 1, table.extents.halfX[row]);
                assertEquals(rowOfLast, table.listed.rowOf(agents[3]));
            }
        }

        [Test]
        public function aPlaceThatIsSetIsWhereTheNextMotionBegins():void
        {
            var agent:Agent = _agents[3];
            var row:int = _table.listed.rowOf(agent);
            agent.jumpTo(5, 0, 0);
            _table.read(_agents);
            var revision:int = agent.revision;
            _table.writeLastPlace(row, 2, 0, 0, true);
            assertEquals("the agent is as it was", revision, agent.revision);
            assertTrue(_table.isMotionStart(row));
            _table.readBodies(_agents);
            assertEquals("rows to read", _agents.length, _table.changes.rows.count);
            assertEquals(2, _table.places.x[row]);
            _table.readPlaces();
            assertEquals(5, _table.places.x[row]);
            _table.writeLastPlace(row, 5, 0, 0, false);
            assertTrue(!_table.isMotionStart(row));
        }

        [Test]
        public function aRefreshedAgentIsSeenAsItIs():void
        {
            var random:SeededRandom = new SeededRandom(741);
            var land:GreatLand = landOf(BuiltInModel.cube(), BuiltInModel.cylinder(), BuiltInModel.sphere());
            for each (var name:String in EachCollider.NAMES)
            {
                var collider:Collider = EachCollider.make(name, land);
                var agents:Vector.<Agent> = RandomWorlds.mixed(12, ["cube", "cylinder", "sphere"], 2, random);
                var queries:AgentQueries = new AgentQueries(collider);
                queries.update(agents);
                var touching:int = 0;
                var apart:int = 0;
                for (var i:int = 0; i < 60; i++)
                {
                    var changed:Agent = agents[random.integer(0, agents.length - 1)];
                    change(changed, random);
                    queries.refresh(changed);
                    for each (var asker:Agent in agents)
                    {
                        var isTouching:Boolean = asker != changed && collider.areColliding(asker, changed);
                        touching += isTouching ? 1 : 0;
                        apart += isTouching ? 0 : 1;
                        assertEquals(name + ", change " + i, isTouching, queries.touching(asker).indexOf(changed) >= 0);
                    }
                }
                assertTrue(name + ": " + touching + " touch, " + apart + " do not", touching > 60 && apart > 60);
            }
        }

        // Moves an agent, turns it, or changes its size or its shape: one of these, or several.
        private static function change(agent:Agent, random:SeededRandom):void
        {
            if (random.chance())
            {
                agent.moveTo(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
            }
            if (random.chance())
            {
                agent.heading = random.between(0, 360);
                agent.pitch = random.between(-90, 90);
            }
            if (random.chance())
            {
                agent.size = random.logBetween(0.3, 5);
            }
            if (random.chance(0.2))
            {
                agent.shape = random.pick(["cube", "cylinder", "sphere"]);
            }
        }

        // An agent has a row if it is listed, and only then.
        private function assertHasOnly(listed:Vector.<Agent>):void
        {
            var count:int = 0;
            for (var row:int = 0; row < _table.listed.rowCapacity; row++)
            {
                var agent:Agent = _table.listed.agentsByRow[row];
                var isListed:Boolean = agent != null && listed.indexOf(agent) >= 0;
                count += isListed ? 1 : 0;
                // rows that a refused list has added have no columns yet
                assertTrue("no shape without a listed agent", isListed || row >= _table.shapes.length || _table.shapes[row] == null);
                if (agent != null)
                {
                    // agents of a list that was refused may still have rows
                    assertEquals("the row of " + agent, isListed ? row : -1, _table.listed.rowOf(agent));
                }
            }
            assertEquals(listed.length, count);
        }
    }
}

import flash.geom.Vector3D;
import starlogo.GreatLand;
import starlogo.agents.Agent;
import starlogo.bounding.Sphere;
import starlogo.models.BuiltInModel;
import starlogo.search.ModelShape;
import starlogo.search.ShapeChoice;

/** Gives spheres to all models but "sphere", which it refuses. The first "cylinder" adds that model. */
internal class AddingChoice extends ShapeChoice
{
    public function AddingChoice(greatLand:GreatLand)
    {
        super(greatLand);
    }

    override public function bind(shape:ModelShape, agent:Agent):void
    {
        if (agent.shape == "cylinder")
        {
            greatLand.addModel(BuiltInModel.sphere());
        }
        if (agent.shape != "sphere")
        {
            shape.setStructure(new Sphere(new Vector3D(0, 0, 0.5), 0.5));
        }
    }
}
