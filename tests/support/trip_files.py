"""Trips written by the tests as programs save them: TOML, CSV, workbooks, GeoPackages."""

import csv
import dataclasses
import io
import json
from datetime import datetime

import geopandas
import openpyxl
import pandas
import shapely

from platoon_osm.driving.state import DriverState
from platoon_osm.network.location import Place
from platoon_osm.plans.trip import TIMES

KEYS = (*TIMES, "flexibility_min")


def place_cells(end, place, number=repr):
    """Return the cells of a place, by column."""
    label = {}
    if isinstance(place, Place):
        label = {f"{end}_label": place.label} if place.label else {}
        if place.osmid is not None:
            return {f"{end}_osmid": place.osmid, **label}
        place = place.at
    if isinstance(place, tuple):
        lon, lat = (number(part) for part in place)
        return {f"{end}_lon": lon, f"{end}_lat": lat, **label}
    return {end: place, **label}


TOLD_IN = {
    "driven_since_break_s": ("min", 60), "driven_today_s": ("h", 3600), "duty_s": ("s", 1),
    "driven_this_week_s": ("h", 3600), "driven_last_week_s": ("min", 60),
    "since_weekly_rest_s": ("s", 1),
}  # fmt: skip
"""The unit in which each time of a driver is written; all of them are read."""


def told_state(state):
    """Return what differs from a rested driver, by the keys of scenarios."""
    told = {}
    for item in dataclasses.fields(DriverState):
        value = getattr(state, item.name)
        if value == item.default:
            continue
        if item.name in TOLD_IN:
            unit, seconds = TOLD_IN[item.name]
            told[item.name.removesuffix("s") + unit] = value / seconds
        else:
            told[item.name] = value
    return told


def driver_cells(state, number=repr):
    """Return the cells of a driver, by column."""
    return {
        key if key == "drivers" else f"driver_{key}": number(value)
        for key, value in told_state(state).items()
    }


def rows_of(trips, number=repr, moment=datetime.isoformat):
    """Return the cells of each trip by column; those it says nothing of are missing."""
    rows = []
    for trip in trips:
        row = {"vehicle": trip.vehicle}
        for end in ("origin", "destination"):
            row |= place_cells(end, getattr(trip, end), number)
        for key in KEYS:
            value = getattr(trip, key)
            if value is not None:
                row[key] = moment(value) if key in TIMES else number(value)
        row |= driver_cells(trip.driver, number)
        rows.append(row)
    return rows


def columns_of(rows):
    """Return the columns that rows have, each once."""
    return list(dict.fromkeys(key for row in rows for key in row))


def as_csv(rows, delimiter=",", ends="\r\n", title=str):
    """Write rows as CSV."""
    text = io.StringIO()
    writer = csv.writer(text, delimiter=delimiter, lineterminator=ends)
    columns = columns_of(rows)
    writer.writerow([title(column) for column in columns])
    for row in rows:
        writer.writerow([row.get(column, "") for column in columns])
    return text.getvalue()


def write_xlsx(path, rows, sheet="Trips", title=str):
    """Write rows as a workbook; text stays text, also where it looks like a formula."""
    book = openpyxl.Workbook()
    page = book.active
    page.title = sheet
    columns = columns_of(rows)
    page.append([title(column) for column in columns])
    for number, row in enumerate(rows, 2):
        for k, column in enumerate(columns, 1):
            cell = page.cell(number, k, row.get(column))
            if isinstance(cell.value, str):
                cell.data_type = "s"
    book.save(path)
    return path


def write_gpkg(path, rows, geometry=None, crs="EPSG:4326", layer="trips"):
    """Write rows as a layer of a GeoPackage, without geometry if none is given."""
    table = pandas.DataFrame(rows, columns=columns_of(rows))
    if geometry is None:
        geometry = [None] * len(rows)
    geopandas.GeoDataFrame(table, geometry=geometry, crs=crs).to_file(path, layer=layer)
    return path


def line(*points):
    """Return a line through points."""
    return shapely.LineString(points)


def toml_value(value):
    """Write a value of a trip as TOML."""
    if isinstance(value, Place):
        told = {"at": value.at, "osmid": value.osmid, "label": value.label}
        inside = (f"{key} = {toml_value(part)}" for key, part in told.items() if part is not None)
        return "{" + ", ".join(inside) + "}"
    if isinstance(value, tuple):
        return "[" + ", ".join(repr(part) for part in value) + "]"
    if isinstance(value, datetime):
        return value.isoformat()
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)


def as_toml(trips, head='network = "italy-motorways"\n'):
    """Write trips as a scenario."""
    text = head
    for trip in trips:
        text += "\n[[trips]]\n"
        for key in ("vehicle", "origin", "destination", *KEYS):
            value = getattr(trip, key)
            if value is not None:
                text += f"{key} = {toml_value(value)}\n"
        if told := told_state(trip.driver):
            text += "\n[trips.driver]\n"
            text += "".join(f"{key} = {json.dumps(value)}\n" for key, value in told.items())
    return text
